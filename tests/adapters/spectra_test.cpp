#include <concino/adapters/spectra.hpp>

#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/ldlt.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace concino;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Minus the second differences of n values with free ends.
Eigen::SparseMatrix<double> chain(int n) {
  Eigen::SparseMatrix<double> a(n, n);
  for (int i = 0; i < n; ++i) {
    a.insert(i, i) = i == 0 || i == n - 1 ? 1 : 2;
    if (i > 0) a.insert(i - 1, i) = a.insert(i, i - 1) = -1;
  }
  return a;
}

Eigen::SparseMatrix<double> identity(int n, double value = 1) {
  Eigen::SparseMatrix<double> a(n, n);
  a.setIdentity();
  return value * a;
}

double chain_value(int n, int k) { return 4 * std::pow(std::sin(std::numbers::pi * k / (2.0 * n)), 2); }

/// The block diagonal matrix of `times` copies of a.
Eigen::SparseMatrix<double> repeated(const Eigen::SparseMatrix<double>& a, int times) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto n = static_cast<int>(a.cols());
  for (int t = 0; t < times; ++t)
    for (int c = 0; c < n; ++c)
      for (Eigen::SparseMatrix<double>::InnerIterator it(a, c); it; ++it)
        entries.emplace_back(t * n + static_cast<int>(it.row()), t * n + c, it.value());
  Eigen::SparseMatrix<double> r(times * n, times * n);
  r.setFromTriplets(entries.begin(), entries.end());
  return r;
}

double worst_product(const Eigen::MatrixXd& u, const Eigen::SparseMatrix<double>& m) {
  return (u.transpose() * (m * u) - Eigen::MatrixXd::Identity(u.cols(), u.cols())).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("eigenpairs: a chain has the known eigenvalues, by iteration and by the dense solver") {
  for (const int n : {2, 10, 100}) {
    for (const int count : {1, 3, n / 2, n - 1, n}) {
      if (count < 1 || count > n) continue;
      const auto r = eigenpairs(chain(n), identity(n), static_cast<std::size_t>(count));
      REQUIRE(r.values.size() == count);
      for (int k = 0; k < count; ++k) CHECK(std::abs(r.values[k] - chain_value(n, k)) < 1e-11);
      CHECK(r.residuals.maxCoeff() < 1e-9);
      CHECK(worst_product(r.vectors, identity(n)) < 1e-13);
      CHECK(r.vectors.rows() == n);
      CHECK(r.isolated == 0);
      CHECK((r.solves > 0) == (n == 100 && count < 50));  // others are solved by the dense solver
      const Eigen::VectorXd again = eigenpairs(chain(n), identity(n), static_cast<std::size_t>(count)).values;
      CHECK(again == r.values);
    }
  }
}

TEST_CASE("eigenpairs: multiple eigenvalues are repeated, also zeros") {
  for (const int times : {2, 3, 5}) {
    const int n = 40;
    const auto r = eigenpairs(repeated(chain(n), times), identity(times * n), static_cast<std::size_t>(3 * times));
    for (int k = 0; k < 3 * times; ++k) CHECK(std::abs(r.values[k] - chain_value(n, k / times)) < 1e-11);
    CHECK(worst_product(r.vectors, identity(times * n)) < 1e-13);
    CHECK(r.residuals.maxCoeff() < 1e-9);
  }
  const auto zero = eigenpairs(0 * identity(50), identity(50), 4);
  CHECK(zero.values.cwiseAbs().maxCoeff() < 1e-15);
}

TEST_CASE("eigenpairs: accepts masses, lower triangles, solvers, shifts and isolated rows") {
  const int n = 80;
  Eigen::SparseMatrix<double> full = identity(n, 4.0 / 6 + 1);
  full = full - chain(n) / 6;
  for (const Eigen::SparseMatrix<double>& m : {identity(n, 3), full}) {
    const auto r = eigenpairs(chain(n), m, 6);
    CHECK(worst_product(r.vectors, m) < 1e-13);
    CHECK((chain(n) * r.vectors - m * r.vectors * r.values.asDiagonal()).cwiseAbs().maxCoeff() < 1e-9);
    for (int k = 1; k < 6; ++k) CHECK(r.values[k] > r.values[k - 1]);
    for (int k = 0; k < 6; ++k) {
      CHECK(r.vectors.col(k).maxCoeff() >= r.vectors.col(k).cwiseAbs().maxCoeff() * (1 - 1e-5));
    }
    const auto lower = eigenpairs(chain(n).triangularView<Eigen::Lower>(), m.triangularView<Eigen::Lower>(), 6);
    const auto by_cg = eigenpairs(chain(n), m, 6, {}, conjugate_gradients{});
    const auto shifted = eigenpairs(chain(n), m, 6, {.shift = 0.5});
    ldlt own;
    const auto by_own = eigenpairs(chain(n), m, 6, {}, own);
    for (int k = 0; k < 6; ++k) {
      CHECK(lower.values[k] == r.values[k]);
      for (const auto* other : {&by_cg, &shifted, &by_own}) CHECK(std::abs(other->values[k] - r.values[k]) < 1e-10);
    }
  }
  // rows without entries between others
  std::vector<Eigen::Triplet<double>> entries;
  const Eigen::SparseMatrix<double> inner = chain(60);
  for (int c = 0; c < 60; ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator it(inner, c); it; ++it) entries.emplace_back(2 * static_cast<int>(it.row()), 2 * c, it.value());
  Eigen::SparseMatrix<double> sparse(121, 121), mass(121, 121);
  sparse.setFromTriplets(entries.begin(), entries.end());
  for (int c = 0; c < 60; ++c) mass.insert(2 * c, 2 * c) = 1;
  mass.insert(119, 119) = 0;
  const auto r = eigenpairs(sparse, mass, 5);
  CHECK(r.isolated == 61);
  for (int k = 0; k < 5; ++k) CHECK(std::abs(r.values[k] - chain_value(60, k)) < 1e-11);
  for (int i = 1; i < 121; i += 2) CHECK(r.vectors.row(i).cwiseAbs().maxCoeff() == 0);
}

TEST_CASE("eigenpairs: residuals are at most the tolerance times the eigenvalue plus the shift") {
  for (const int n : {60, 300, 900}) {
    Eigen::SparseMatrix<double> graded = identity(n), k = chain(n);
    for (int i = 0; i < n; ++i) graded.coeffRef(i, i) = 1 + 30.0 * (i % 7) / n;
    for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
      const double shift = 2.0 / n;
      const auto r = eigenpairs(k, graded, 9, {.tolerance = tolerance, .shift = shift});
      double worst = 0;
      for (int i = 0; i < 9; ++i) {
        const Eigen::VectorXd u = r.vectors.col(i), mu = graded * u;
        worst = std::max(worst, (k * u - r.values[i] * mu).norm() / mu.norm() / (r.values[i] + shift));
      }
      CHECK(worst <= tolerance);
    }
  }
}

TEST_CASE("eigenpairs: throws if an argument is invalid") {
  const auto k = chain(50), m = identity(50);
  CHECK_THROWS_WITH_AS(eigenpairs(k, m, 0), "eigenpairs: 0 eigenpairs are requested; the problem has 50 rows with entries, so request 1 to 50", invalid_argument);
  CHECK_THROWS_AS(eigenpairs(k, m, 51), invalid_argument);
  CHECK_THROWS_AS(eigenpairs(Eigen::SparseMatrix<double>(3, 3), Eigen::SparseMatrix<double>(3, 3), 1), invalid_argument);
  CHECK_THROWS_WITH_AS(eigenpairs(k, identity(49), 3), "eigenpairs: the mass has 49 rows, the other matrix 50; they must be of the same size",
                       invalid_argument);
  CHECK_THROWS_AS(eigenpairs(Eigen::SparseMatrix<double>(3, 2), Eigen::SparseMatrix<double>(3, 2), 1), solver_error);
  for (const double bad : {0.0, 1.0, -1e-10, std::nan("")}) CHECK_THROWS_AS(eigenpairs(k, m, 3, {.tolerance = bad}), invalid_argument);
  for (const double bad : {-1.0, infinity, std::nan("")}) CHECK_THROWS_AS(eigenpairs(k, m, 3, {.shift = bad}), invalid_argument);
  CHECK_THROWS_AS(eigenpairs(k, m, 3, {.max_restarts = 0}), invalid_argument);
  CHECK_THROWS_WITH_AS(eigenpairs(chain(400), identity(400), 20, {.max_restarts = 1}), doctest::Contains("of 20 have converged after 1 restarts"),
                       solver_error);
  for (const double bad : {infinity, std::nan("")}) {
    auto k_bad = k, m_bad = m;
    k_bad.coeffRef(7, 7) = m_bad.coeffRef(7, 7) = bad;
    CHECK_THROWS_WITH_AS(eigenpairs(k_bad, m, 3), doctest::Contains("not finite, in row 7, column 7"), solver_error);
    CHECK_THROWS_WITH_AS(eigenpairs(k, m_bad, 3), doctest::Contains("eigenpairs, mass: the matrix has an entry"), solver_error);
  }
  auto massless = m;
  massless.coeffRef(9, 9) = 0;
  CHECK_THROWS_WITH_AS(eigenpairs(k, massless, 3), "eigenpairs: row 9 has no positive mass, so it has no finite eigenvalue; leave it out",
                       solver_error);
  auto indefinite = identity(6);
  indefinite.coeffRef(1, 0) = indefinite.coeffRef(0, 1) = 5;
  CHECK_THROWS_WITH_AS(eigenpairs(chain(6), indefinite, 3), "eigenpairs: the mass matrix is not positive definite", solver_error);
}
