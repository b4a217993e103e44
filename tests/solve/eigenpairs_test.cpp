#include <concino/solve/eigenpairs.hpp>

#include <support/systems.hpp>
#include <support/threads.hpp>

#include <Eigen/Dense>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace concino;
using namespace systems;

namespace {

/// Minus the second differences of n values with free ends.
sparse free_chain(int n) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, i == 0 || i == n - 1 ? 1.0 : 2.0);
  for (int i = 1; i < n; ++i) entries.emplace_back(i, i - 1, -1.0), entries.emplace_back(i - 1, i, -1.0);
  return from(n, n, entries);
}

double free_chain_value(int n, int k) { return 4 * std::pow(std::sin(std::numbers::pi * k / (2.0 * n)), 2); }

sparse masses(Eigen::Index n, double value = 1) {
  sparse a(n, n);
  a.setIdentity();
  return value * a;
}

/// The block diagonal matrix of `times` copies of a.
sparse copies(const sparse& a, int times) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto n = static_cast<int>(a.cols());
  for (int t = 0; t < times; ++t)
    for (int c = 0; c < n; ++c)
      for (sparse::InnerIterator it(a, c); it; ++it) entries.emplace_back(t * n + static_cast<int>(it.row()), t * n + c, it.value());
  return from(times * n, times * n, entries);
}

double largest_mass_error(const Eigen::MatrixXd& u, const sparse& m) {
  return (u.transpose() * (m * u) - Eigen::MatrixXd::Identity(u.cols(), u.cols())).cwiseAbs().maxCoeff();
}

/// The laws of every result: order, residuals as reported, vectors orthonormal.
void check_laws_of(const eigenpairs_result& r, const sparse& k, const sparse& m, double shift, double tolerance) {
  CHECK(r.has_converged);
  CHECK(largest_mass_error(r.vectors, m) < 1e-13);
  for (Eigen::Index i = 0; i < r.values.size(); ++i) {
    if (i > 0) CHECK(r.values[i] >= r.values[i - 1]);
    const Eigen::VectorXd u = r.vectors.col(i), mu = m * u;
    const double residual = (k * u - r.values[i] * mu).norm() / mu.norm();
    CHECK(residual <= std::max(1.01 * tolerance * (r.values[i] + shift), 1e-14));  // or rounding errors
    CHECK(std::abs(r.residuals[i] - residual) < 1e-3 * residual + 1e-14);
    CHECK(u.maxCoeff() >= u.cwiseAbs().maxCoeff() * (1 - 1e-5));
  }
}

/// Compares the first eigenvalues with those of a dense solver.
void compare_with_dense(const sparse& k, const sparse& m, std::size_t count, double shift) {
  const auto r = eigenpairs(k, m, count, lobpcg, {.shift = shift});
  CHECK(r.iterations > 0);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> dense(k.toDense(), m.toDense());
  const double largest = dense.eigenvalues()[k.cols() - 1];
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    CHECK(std::abs(r.values[at] - dense.eigenvalues()[at]) < 1e-11 * largest);
  }
  check_laws_of(r, k, m, shift, 1e-8);
}

}  // namespace

TEST_CASE("eigenpairs by LOBPCG: chains and grids have the known eigenvalues") {
  for (const int n : {256, 700})
    for (const std::size_t count : {1u, 7u}) {
      const auto r = eigenpairs(free_chain(n), masses(n), count, lobpcg, {.shift = 1.0 / n / n});
      CHECK(r.iterations >= 3);
      CHECK(r.iterations < 60);
      CHECK(r.solves >= r.iterations);
      for (std::size_t k = 0; k < count; ++k)
        CHECK(std::abs(r.values[static_cast<Eigen::Index>(k)] - free_chain_value(n, static_cast<int>(k))) < 1e-13 + 1e-9 * free_chain_value(n, static_cast<int>(k)));
      check_laws_of(r, free_chain(n), masses(n), 1.0 / n / n, 1e-8);
    }
  const int n = 24;
  std::vector<double> known;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) known.push_back(free_chain_value(n, i) + free_chain_value(n, j));
  std::sort(known.begin(), known.end());
  const auto r = eigenpairs(grid(n, 0), masses(n * n, 2), 25, lobpcg);
  for (std::size_t k = 0; k < 25; ++k) CHECK(std::abs(r.values[static_cast<Eigen::Index>(k)] - known[k] / 2) < 1e-13);
  CHECK(r.iterations < 30);
  CHECK(r.isolated == 0);
}

TEST_CASE("eigenpairs by LOBPCG: agree with a dense solver, for masses of any form") {
  const int n = 17;
  sparse graded = masses(n * n);
  for (int i = 0; i < n * n; ++i) graded.coeffRef(i, i) = 1 + 30.0 * (i % 7);
  const sparse galerkin = masses(n * n, 2) - grid(n, 0) / 6, biharmonic = grid(n, 0) * grid(n, 0);
  compare_with_dense(grid(n, 0), graded, 12, 0.01);
  compare_with_dense(grid(n, 0.5), galerkin, 5, 0.01);
  compare_with_dense(biharmonic, graded, 5, 1e-4);
  sparse with_penalties = grid(n, 0);
  for (int i = 0; i < n * n; i += 13) with_penalties.coeffRef(i, i) += 1e6;
  const auto by_default = eigenpairs(with_penalties, masses(n * n), 5, lobpcg), unpenalised = eigenpairs(grid(n, 0), masses(n * n), 5, lobpcg);
  check_laws_of(by_default, with_penalties, masses(n * n), 1, 1e-8);
  CHECK(by_default.iterations <= 2 * unpenalised.iterations);
}

TEST_CASE("eigenpairs by LOBPCG: multiple eigenvalues are repeated, and components have one zero each") {
  for (const int times : {2, 5, 20}) {
    const int n = 10;
    const std::size_t count = 12;
    const auto r = eigenpairs(copies(grid(n, 0), times), masses(times * n * n), count, lobpcg);
    for (std::size_t k = 0; k < count; ++k) {
      const double known = k < static_cast<std::size_t>(times) ? 0 : free_chain_value(n, 1);
      if (k < 3 * static_cast<std::size_t>(times)) CHECK(std::abs(r.values[static_cast<Eigen::Index>(k)] - known) < 1e-12);
    }
    CHECK(largest_mass_error(r.vectors, masses(times * n * n)) < 1e-13);
  }
  const auto zero = eigenpairs(0 * masses(500), masses(500), 4, lobpcg);
  CHECK(zero.values.cwiseAbs().maxCoeff() < 1e-15);
  const auto equal = eigenpairs(masses(500, 3), masses(500, 2), 20, lobpcg);
  for (int k = 0; k < 20; ++k) CHECK(equal.values[k] == doctest::Approx(1.5).epsilon(1e-14));
}

TEST_CASE("eigenpairs by LOBPCG: diagonal matrices, rows without entries, and few rows") {
  sparse diagonal(500, 500);
  for (int i = 0; i < 500; ++i) diagonal.insert(i, i) = 1 + (i * 7) % 500;
  const auto r = eigenpairs(diagonal, masses(500), 5, lobpcg);
  for (int k = 0; k < 5; ++k) CHECK(r.values[k] == doctest::Approx(k + 1).epsilon(1e-12));
  const auto one = eigenpairs(masses(1, 6), masses(1, 4), 1, lobpcg);
  CHECK(one.values[0] == 1.5);
  CHECK(one.vectors(0, 0) == 0.5);
  CHECK(one.iterations == 0);
  for (const int n : {2, 40, 120})
    for (const int count : {1, 2, n}) {
      const auto few = eigenpairs(free_chain(n), masses(n), static_cast<std::size_t>(count), lobpcg);
      for (int k = 0; k < count; ++k) CHECK(std::abs(few.values[k] - free_chain_value(n, k)) < 1e-12);
    }
  const auto many = eigenpairs(free_chain(256), masses(256), 70, lobpcg);  // too many of them for the iteration
  for (int k = 0; k < 70; ++k) CHECK(std::abs(many.values[k] - free_chain_value(256, k)) < 1e-12);
  CHECK(many.iterations == 0);
  std::vector<Eigen::Triplet<double>> entries, mass_entries;
  const sparse inner = grid(20, 0);
  for (int c = 0; c < 400; ++c) {
    for (sparse::InnerIterator it(inner, c); it; ++it) entries.emplace_back(2 * static_cast<int>(it.row()), 2 * c, it.value());
    mass_entries.emplace_back(2 * c, 2 * c, 1.0);
  }
  mass_entries.emplace_back(799, 799, 0.0);
  const auto gaps = eigenpairs(from(801, 801, entries), from(801, 801, mass_entries), 5, lobpcg), whole = eigenpairs(inner, masses(400), 5, lobpcg);
  CHECK(gaps.isolated == 401);
  CHECK(gaps.values == whole.values);
  for (int i = 1; i < 801; i += 2) CHECK(gaps.vectors.row(i).cwiseAbs().maxCoeff() == 0);
  for (int i = 0; i < 400; ++i) CHECK(gaps.vectors.row(2 * i) == whole.vectors.row(i));
}

TEST_CASE("eigenpairs by LOBPCG: residuals meet the tolerance, and only the lower triangles are read") {
  const sparse k = grid(20, 0), m = masses(400, 0.7);
  std::size_t before = 0;
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const auto r = eigenpairs(k, m, 5, lobpcg, {.tolerance = tolerance, .shift = 0.01});
    check_laws_of(r, k, m, 0.01, std::max(tolerance, 1e-11));
    CHECK(r.iterations > before);
    before = r.iterations;
  }
  const auto r = eigenpairs(k, m, 5, lobpcg), lower = eigenpairs(k.triangularView<Eigen::Lower>(), m.triangularView<Eigen::Lower>(), 5, lobpcg);
  CHECK(lower.values == r.values);
  CHECK(lower.vectors == r.vectors);
  CHECK(eigenpairs(k, m, 5, lobpcg, {.tolerance = 1e-300}).has_converged);  // to rounding errors
}

TEST_CASE("eigenpairs by LOBPCG: scaling by powers of two scales exactly, threads change nothing") {
  const sparse k = grid(17, 0), m = masses(289, 2) - k / 6;
  const auto r = eigenpairs(k, m, 4, lobpcg);
  for (const auto& [by, mass_by] : {std::pair{10, 0}, {-300, -200}, {300, 200}}) {
    const auto s = eigenpairs(std::ldexp(1, by) * k, std::ldexp(1, mass_by) * m, 4, lobpcg);
    for (int i = 0; i < 4; ++i) {
      CHECK(s.values[i] == std::ldexp(r.values[i], by - mass_by));
      CHECK(s.residuals[i] == std::ldexp(r.residuals[i], by - mass_by));
    }
    CHECK(s.vectors * std::ldexp(1, mass_by / 2) == r.vectors);
  }
  const sparse large = grid(50, 0), unit = masses(2500);  // several parts of the rows, and more than one panel of vectors
  const auto one = eigenpairs(large, unit, 9, lobpcg, {.tolerance = 1e-4});
  for (const int threads : {1, 3}) {
    const testing::with_num_threads set(threads);
    const auto again = eigenpairs(large, unit, 9, lobpcg, {.tolerance = 1e-4});
    CHECK(again.values == one.values);
    CHECK(again.vectors == one.vectors);
  }
}

TEST_CASE("eigenpairs by LOBPCG: report progress and can be cancelled") {
  double last = -1;
  int calls = 0;
  const auto follow = [&](double fraction, const char* label) {
    CHECK(fraction >= last);
    CHECK(fraction <= 1);
    CHECK(std::string(label) == "eigenpairs");
    last = fraction;
    ++calls;
    return true;
  };
  const auto r = eigenpairs(grid(30, 0), masses(900), 6, lobpcg, {.progress = follow});
  CHECK(calls > static_cast<int>(r.iterations));
  CHECK(last == 1);
  int left = 5;
  const auto stop = [&](double, const char*) { return --left > 0; };
  CHECK_THROWS_WITH_AS(eigenpairs(grid(30, 0), masses(900), 6, lobpcg, {.progress = stop}), doctest::Contains("eigenpairs: stopped"), cancelled);
  CHECK(left == 0);
}

TEST_CASE("eigenpairs by LOBPCG: a missed tolerance is an error, or by option a flag") {
  const sparse k = grid(30, 0), m = masses(900);
  CHECK_THROWS_WITH_AS(eigenpairs(k, m, 6, lobpcg, {.max_iterations = 3}), doctest::Contains("of 6 have converged after 3 iterations; residuals are up to "),
                       solver_error);
  const auto r = eigenpairs(k, m, 6, lobpcg, {.max_iterations = 3, .accept_missed_tolerance = true});
  CHECK_FALSE(r.has_converged);
  CHECK(r.iterations == 3);
  CHECK(largest_mass_error(r.vectors, m) < 1e-13);
  const auto exact = eigenpairs(k, m, 6, lobpcg);
  for (int i = 0; i < 6; ++i) {
    CHECK(r.values[i] >= exact.values[i] - 1e-12);  // Rayleigh quotients
    CHECK(r.values[i] < exact.values[i] + 0.1);
  }
}

TEST_CASE("eigenpairs by LOBPCG: throws if an argument is invalid") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const sparse k = grid(20, 0), m = masses(400);
  CHECK_THROWS_WITH_AS(eigenpairs(k, m, 0, lobpcg), "eigenpairs: 0 eigenpairs are requested; the problem has 400 rows with entries, so request 1 to 400", invalid_argument);
  CHECK_THROWS_AS(eigenpairs(k, m, 401, lobpcg), invalid_argument);
  CHECK_THROWS_AS(eigenpairs(sparse(3, 3), sparse(3, 3), 1, lobpcg), invalid_argument);
  CHECK_THROWS_AS(eigenpairs(k, masses(399), 3, lobpcg), invalid_argument);
  CHECK_THROWS_AS(eigenpairs(sparse(3, 2), sparse(3, 2), 1, lobpcg), solver_error);
  for (const double bad : {0.0, 1.0, -1e-10, std::nan("")}) CHECK_THROWS_AS(eigenpairs(k, m, 3, lobpcg, {.tolerance = bad}), invalid_argument);
  for (const double bad : {-1.0, infinity, std::nan("")}) CHECK_THROWS_AS(eigenpairs(k, m, 3, lobpcg, {.shift = bad}), invalid_argument);
  CHECK_THROWS_AS(eigenpairs(k, m, 3, lobpcg, {.max_iterations = 0}), invalid_argument);
  for (const double bad : {infinity, std::nan("")}) {
    sparse k_bad = k, m_bad = m;
    k_bad.coeffRef(7, 7) = m_bad.coeffRef(7, 7) = bad;
    CHECK_THROWS_WITH_AS(eigenpairs(k_bad, m, 3, lobpcg), doctest::Contains("not finite, in row 7, column 7"), solver_error);
    CHECK_THROWS_WITH_AS(eigenpairs(k, m_bad, 3, lobpcg), doctest::Contains("eigenpairs, mass: the matrix has an entry"), solver_error);
  }
  sparse massless = m;
  massless.coeffRef(9, 9) = 0;
  CHECK_THROWS_WITH_AS(eigenpairs(k, massless, 3, lobpcg), "eigenpairs: row 9 has no positive mass, so it has no finite eigenvalue; leave it out", solver_error);
  CHECK_THROWS_WITH_AS(eigenpairs(-k, m, 3, lobpcg), doctest::Contains("eigenpairs: the matrix is not positive semidefinite: the diagonal entry of row 21 is negative"), solver_error);
  CHECK_THROWS_WITH_AS(eigenpairs(grid(20, -1), m, 3, lobpcg), doctest::Contains("it has an eigenvalue below minus the shift"), solver_error);
  CHECK_THROWS_WITH_AS(eigenpairs(k, masses(400, 0.2) - k, 3, lobpcg), doctest::Contains("row 0 has no positive mass"), solver_error);
  const sparse indefinite = masses(400, 5) - grid(20, 0);  // the largest eigenvalue of the grid is almost 8
  CHECK_THROWS_WITH_AS(eigenpairs(-k + masses(400, 8), indefinite, 3, lobpcg), doctest::Contains("the mass matrix is not positive definite"), solver_error);
  sparse huge = k;
  huge.coeffRef(41, 1) = huge.coeffRef(1, 41) = -1e300;
  CHECK_THROWS_AS(eigenpairs(huge, m, 3, lobpcg), solver_error);
}
