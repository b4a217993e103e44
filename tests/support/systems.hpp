// Linear systems for tests of solvers, and the laws that every solver must fulfil.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/error.hpp>

#include <doctest/doctest.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <random>
#include <vector>

namespace systems {

using sparse = Eigen::SparseMatrix<double>;

inline sparse from(int rows, int columns, const std::vector<Eigen::Triplet<double>>& entries) {
  sparse a(rows, columns);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

/// The Laplacian of a grid of n x n verts, positive, plus `more` on the diagonal: definite if more is positive, singular if it is 0.
inline sparse grid(int n, double more = 0.5, double skew = 0) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto edge = [&](int i, int j) {
    for (const int k : {i, j}) entries.emplace_back(k, k, 1.0);
    entries.emplace_back(i, j, -1 - skew);
    entries.emplace_back(j, i, -1 + skew);
  };
  for (int i = 0; i < n * n; ++i) {
    entries.emplace_back(i, i, more);
    if (i % n) edge(i, i - 1);
    if (i >= n) edge(i, i - n);
  }
  return from(n * n, n * n, entries);
}

inline Eigen::VectorXd random_vector(Eigen::Index n, unsigned seed = 3) {
  std::mt19937 random(seed);
  Eigen::VectorXd x(n);
  for (double& xi : x) xi = static_cast<double>(random() % 2001) / 1000 - 1;
  return x;
}

inline double distance(const Eigen::VectorXd& x, const Eigen::VectorXd& y) { return x.size() == 0 ? 0.0 : (x - y).cwiseAbs().maxCoeff(); }

/// Checks the laws of solvers on definite systems of up to n x n unknowns; one unknown has a unit in which its coefficient is `small`.
template<class S>
void check_solver(S& solver, int n, double small = 0x1p-40) {
  static_assert(concino::SparseSolver<S, sparse, Eigen::VectorXd>);
  using concino::solver_error;
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(4);
  CHECK_THROWS_WITH_AS(solver.solve(one), doctest::Contains("solve without a factorised matrix"), solver_error);
  for (const int k : {1, 2, n}) {  // small and large; many right-hand sides
    const sparse a = grid(k);
    solver.factorize(a);
    for (unsigned seed = 0; seed < 3; ++seed) {
      const Eigen::VectorXd x = random_vector(a.cols(), seed);
      CHECK(distance(solver.solve(a * x), x) < 1e-9);
    }
    CHECK(solver.solve(Eigen::VectorXd::Zero(a.cols())) == Eigen::VectorXd::Zero(a.cols()));
    for (const double more : {0.25, 3.0}) {  // other values, same pattern
      const sparse b = grid(k, more);
      solver.factorize(b);
      const Eigen::VectorXd x = random_vector(b.cols());
      CHECK(distance(solver.solve(b * x), x) < 1e-9);
    }
  }
  sparse loose(4, 4);  // an uncompressed matrix
  loose.reserve(Eigen::VectorXi::Constant(4, 4));
  for (int i = 0; i < 4; ++i) loose.insert(i, i) = i + 1;
  solver.factorize(loose);
  CHECK(distance(solver.solve(loose * one), one) < 1e-12);
  sparse disconnected = grid(2);  // with verts without edges
  disconnected.conservativeResize(6, 6);
  disconnected.coeffRef(4, 4) = 2;
  disconnected.coeffRef(5, 5) = small;
  solver.factorize(disconnected);
  const Eigen::VectorXd six = random_vector(6);
  CHECK(distance(solver.solve(disconnected * six), six) < 1e-9);

  solver.factorize(sparse(0, 0));
  CHECK(solver.solve(Eigen::VectorXd(0)).size() == 0);

  solver.factorize(grid(2));
  CHECK_THROWS_WITH_AS(solver.solve(Eigen::VectorXd::Ones(5)), doctest::Contains("5 entries, the matrix 4 rows"), solver_error);
  Eigen::VectorXd b = one;
  b[2] = std::nan("");
  CHECK_THROWS_WITH_AS(solver.solve(b), doctest::Contains("entry 2 of the right-hand side is not finite"), solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(sparse(2, 3)), doctest::Contains("2 rows and 3 columns"), solver_error);
  for (const int k : {0, 1, 2, 4})  // a failed factorisation leaves none
    CHECK_THROWS_WITH_AS(solver.solve(Eigen::VectorXd::Ones(k)), doctest::Contains("solve without a factorised matrix"), solver_error);
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    sparse a = grid(2);
    a.coeffRef(3, 1) = bad;
    CHECK_THROWS_WITH_AS(solver.factorize(a), doctest::Contains("not finite, in row 3, column 1"), solver_error);
  }
  CHECK_THROWS_AS(solver.factorize(sparse(3, 3)), solver_error);  // all zeros
  solver.factorize(grid(2));
  CHECK(distance(grid(2) * solver.solve(one), one) < 1e-12);
}

/// Checks that scaling the matrix or the right-hand side by powers of two scales solutions exactly.
template<class S>
void check_scaling(S& solver) {
  const sparse a = grid(5);
  const Eigen::VectorXd b = random_vector(25);
  solver.factorize(a);
  const Eigen::VectorXd x = solver.solve(b);
  CHECK(solver.solve(b * 0x1p-500) == x * 0x1p-500);
  for (const double s : {0x1p-301, 0x1p21, 0x1p300}) {
    solver.factorize(a * s);
    CHECK(solver.solve(b) == x / s);
  }
}

/// Checks solutions of a system with penalties, which have nearly all of its energy: in the energy without them, and in the largest value. There, a relative
/// residual of 1e-6 would accept solutions that are wrong by more than 1 %. make(tolerance, max_iterations) returns a solver that accepts a missed tolerance.
/// factor: how many tolerances the error in the energy may be, relative to the energy of the solution.
template<class Make>
void check_penalties(int n, double factor, const Make& make) {
  const sparse without = grid(n, 0);
  Eigen::VectorXd expected(n * n);
  for (int i = 0; i < n * n; ++i) expected[i] = 1 + i % n;  // harmonic
  const double range = n - 1, energy = std::sqrt(expected.dot(without * expected));
  for (const double penalty : {1e4, 1e8, 1e12}) {
    sparse a = without;
    for (int i = 0; i < n * n; ++i)
      if (i % n == 0 || i % n == n - 1) a.coeffRef(i, i) += penalty;
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n * n);
    for (int i = 0; i < n * n; ++i)
      if (i % n == 0 || i % n == n - 1) b[i] = penalty * expected[i] + without.row(i).dot(expected);
    for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
      auto solver = make(tolerance, 0);
      solver.factorize(a);
      const Eigen::VectorXd error = solver.solve(b) - expected;
      INFO("penalty " << penalty << ", tolerance " << tolerance);
      CHECK(solver.has_converged());
      CHECK(std::sqrt(error.dot(without * error)) <= factor * tolerance * energy);
      CHECK(error.cwiseAbs().maxCoeff() <= 1e-6 * range);
    }
    double worst_accepted = 0;  // of the first solution with a small relative residual
    for (int iterations = 1; iterations < 200; ++iterations) {
      auto solver = make(1e-10, iterations);
      solver.factorize(a);
      const Eigen::VectorXd x = solver.solve(b);
      if ((b - a * x).norm() > 1e-6 * b.norm()) continue;
      worst_accepted = distance(x, expected);
      break;
    }
    if (penalty >= 1e8) CHECK(worst_accepted > 0.01 * range);
  }
}

/// Checks that the tolerance is met where the rounding errors of a plain sum over a long row are above it: on a wheel that is almost singular.
template<class S>
void check_wheel(S& solver, int spokes) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto edge = [&](int i, int j) {
    for (const int k : {i, j}) entries.emplace_back(k, k, 1.0);
    entries.emplace_back(i, j, -1.0);
    entries.emplace_back(j, i, -1.0);
  };
  for (int i = 0; i < spokes; ++i) {
    edge(i + 1, (i + 1) % spokes + 1);
    edge(0, i + 1);
  }
  for (int i = 0; i <= spokes; ++i) entries.emplace_back(i, i, 1e-3);
  const sparse a = from(spokes + 1, spokes + 1, entries);
  solver.factorize(a);
  const Eigen::VectorXd x = solver.solve(Eigen::VectorXd::Ones(spokes + 1));
  CHECK(solver.has_converged());
  CHECK(distance(x, Eigen::VectorXd::Constant(spokes + 1, 1000)) < 1e-5);  // rounding errors of the entries alone: 1e-16 * spokes / 1e-3, relative
  for (const int at : {0, 5}) {
    Eigen::VectorXd b = Eigen::VectorXd::Zero(spokes + 1);
    b[at] = 1;
    CHECK(std::abs(solver.solve(b).sum() - 1000) < 1e-5);
    CHECK(solver.has_converged());
  }
}

}  // namespace systems
