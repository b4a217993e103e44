#include <concino/solve/ldlt.hpp>

#include <concino/concepts/sparse_solver.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <random>

#include <support/systems.hpp>

using namespace concino;

namespace {

static_assert(SparseSolver<ldlt, Eigen::SparseMatrix<double>, Eigen::VectorXd>);

/// The Laplacian of a path of n verts with both ends constrained: tridiagonal and positive definite.
Eigen::SparseMatrix<double> path(int n, double diagonal = 2) {
  Eigen::SparseMatrix<double> a(n, n);
  for (int i = 0; i < n; ++i) {
    a.insert(i, i) = diagonal;
    if (i > 0) a.insert(i, i - 1) = a.insert(i - 1, i) = -1;
  }
  a.makeCompressed();
  return a;
}

}  // namespace

TEST_CASE("ldlt: fulfils the laws of solvers") {
  ldlt solver;
  systems::check_solver(solver, 40);
}

TEST_CASE("ldlt: the error names the row that makes the matrix singular") {
  ldlt solver;
  auto a = path(3, 1);
  for (const int j : {0, 2}) a.coeffRef(1, j) = a.coeffRef(j, 1) = 0;
  a.coeffRef(1, 1) = 0;
  CHECK_THROWS_WITH_AS(solver.factorize(a),
                       "ldlt: the matrix is singular to working precision in row 1: elimination turns the diagonal entry 0 into 0", solver_error);
}

TEST_CASE("ldlt: the first pivot and a too large one are checked as others") {
  ldlt solver;
  CHECK_THROWS_WITH_AS(solver.factorize(systems::from(1, 1, {{0, 0, 0.0}})), doctest::Contains("in row 0"), solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(systems::from(2, 2, {{0, 0, 1e-300}, {1, 0, 1e10}, {1, 1, 1.0}})), doctest::Contains("into -inf"),
                       solver_error);
}

TEST_CASE("ldlt: the number of entries of the factor can be limited") {
  ldlt solver;
  CHECK(!solver.factorize_within(path(9), 7));
  CHECK_THROWS_AS(solver.solve(Eigen::VectorXd::Ones(9)), solver_error);
  CHECK(solver.factorize_within(path(9), 8));
  CHECK(solver.solve(Eigen::VectorXd::Ones(9)).size() == 9);
  const auto full = systems::from(3, 3, {{0, 0, 4.0}, {1, 0, 1.0}, {2, 0, 1.0}, {1, 1, 4.0}, {2, 1, 1.0}, {2, 2, 4.0}});
  CHECK(!solver.factorize_within(full, 2));
  CHECK(solver.factorize_within(full, 3));
  CHECK(solver.factorize_within(Eigen::SparseMatrix<double>(0, 0), 0));
}

TEST_CASE("ldlt: a factorisation serves many right-hand sides, at any size") {
  std::mt19937 random(3);
  for (const int n : {1, 2, 50, 3000}) {
    const auto a = path(n);
    ldlt solver;
    solver.factorize(a);
    for (int k = 0; k < 3; ++k) {
      Eigen::VectorXd x(n);
      for (double& xi : x) xi = static_cast<double>(random() % 1000) / 1000;
      const Eigen::VectorXd b = a * x;
      CHECK((solver.solve(b) - x).cwiseAbs().maxCoeff() < 1e-8);
    }
  }
}

TEST_CASE("ldlt: reads only the lower triangle, solves indefinite systems, and can be reused") {
  ldlt solver;
  solver.factorize(path(5).triangularView<Eigen::Lower>());
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(5);
  CHECK((path(5) * solver.solve(one) - one).norm() < 1e-14);
  solver.factorize(path(5, 0.5));
  CHECK((path(5, 0.5) * solver.solve(one) - one).norm() < 1e-13);
  solver.factorize(path(3));
  CHECK(solver.solve(Eigen::VectorXd::Ones(3)).size() == 3);
}

TEST_CASE("ldlt: an empty system has an empty solution") {
  ldlt solver;
  solver.factorize(Eigen::SparseMatrix<double>(0, 0));
  CHECK(solver.solve(Eigen::VectorXd(0)).size() == 0);
  solver.factorize(path(2));
  solver.factorize(Eigen::SparseMatrix<double>(0, 0));
  CHECK(solver.solve(Eigen::VectorXd(0)).size() == 0);
}

TEST_CASE("ldlt: a matrix that it cannot solve is an error") {
  ldlt solver;
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(3);
  CHECK_THROWS_WITH_AS(solver.solve(one), "ldlt: solve without a factorised matrix; call factorize first", solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(Eigen::SparseMatrix<double>(2, 3)), doctest::Contains("it must be square"), solver_error);
  auto broken = path(3);
  broken.coeffRef(1, 1) = std::nan("");
  CHECK_THROWS_WITH_AS(solver.factorize(broken), doctest::Contains("not finite"), solver_error);
  auto free_ends = path(3);  // constants are in the kernel
  free_ends.coeffRef(0, 0) = free_ends.coeffRef(2, 2) = 1;
  CHECK_THROWS_WITH_AS(solver.factorize(free_ends), doctest::Contains("singular"), solver_error);
  auto nothing = path(3);
  nothing.coeffRef(1, 1) = nothing.coeffRef(0, 1) = nothing.coeffRef(1, 0) = nothing.coeffRef(2, 1) = nothing.coeffRef(1, 2) = 0;
  CHECK_THROWS_WITH_AS(solver.factorize(nothing), doctest::Contains("singular"), solver_error);
  CHECK_THROWS_AS(solver.solve(one), solver_error);  // after a failed factorisation there is none
  solver.factorize(path(3));
  CHECK_THROWS_WITH_AS(solver.solve(Eigen::VectorXd::Ones(4)), doctest::Contains("4 entries, the matrix 3 rows"), solver_error);
  CHECK_THROWS_WITH_AS(solver.solve(one * std::nan("")), doctest::Contains("not finite"), solver_error);
}

TEST_CASE("ldlt: badly scaled rows are not taken for singular ones") {
  auto a = path(6);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      if (a.coeff(i, j) != 0) a.coeffRef(i, j) *= std::ldexp(1.0, -20 * (i + j));
  ldlt solver;
  solver.factorize(a);
  Eigen::VectorXd x(6);
  for (int i = 0; i < 6; ++i) x[i] = std::ldexp(1.0, 20 * i);
  const Eigen::VectorXd b = a * x;
  CHECK(((solver.solve(b) - x).array() / x.array()).abs().maxCoeff() < 1e-12);
}

TEST_CASE("ldlt: agrees with a dense solver on random matrices, compressed or not") {
  std::mt19937 random(11);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned long>(n)); };
  const auto real = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
  for (int round = 0; round < 200; ++round) {
    const int n = below(40) + 1;
    Eigen::SparseMatrix<double> a(n, n);
    for (int i = 0; i < n; ++i) a.coeffRef(i, i) = 0.5 + real() * real();
    for (int k = below(4 * n); k > 0; --k) {
      const int i = below(n), j = below(n);
      if (i != j) a.coeffRef(std::max(i, j), std::min(i, j)) = real();
    }
    for (int i = 0; i < n; ++i) a.coeffRef(i, i) += 4 * n;  // positive definite
    if (round % 2) a.makeCompressed();
    const Eigen::MatrixXd whole = Eigen::MatrixXd(a).selfadjointView<Eigen::Lower>();
    Eigen::VectorXd b(n);
    for (double& x : b) x = real();
    ldlt solver;
    solver.factorize(a);
    CHECK((whole * solver.solve(b) - b).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((solver.solve(b) - whole.partialPivLu().solve(b)).cwiseAbs().maxCoeff() < 1e-12);
  }
}

TEST_CASE("ldlt: solves with blocks of any width and sparse right-hand sides") {
  std::mt19937 random(7);
  for (int width = 1; width <= 11; ++width) {  // a chain of dense blocks, each coupled with the next, with gaps in between
    const int blocks = 6, n = blocks * width + 1;
    Eigen::SparseMatrix<double> a(n, n);
    for (int b = 0; b < blocks; ++b)
      for (int i = b * width; i < (b + 1) * width; ++i)
        for (int j = b * width; j < std::min(n, (b + 1) * width + b % 3); ++j)
          if (i < j) a.coeffRef(j, i) = -static_cast<double>(1 + random() % 9);
    for (int i = 0; i < n; ++i) a.coeffRef(i, i) = 20 * width;
    a.makeCompressed();
    const Eigen::MatrixXd whole = Eigen::MatrixXd(a).selfadjointView<Eigen::Lower>();
    ldlt solver;
    solver.factorize(a);
    for (int k = 0; k < n; ++k) {
      const Eigen::VectorXd b = Eigen::VectorXd::Unit(n, k);
      CHECK((whole * solver.solve(b) - b).cwiseAbs().maxCoeff() < 1e-13);
    }
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2);
    CHECK((whole * solver.solve(b) - b).cwiseAbs().maxCoeff() < 1e-13);
    CHECK(solver.solve(Eigen::VectorXd::Zero(n)) == Eigen::VectorXd::Zero(n));
  }
}

TEST_CASE("ldlt: an order copied from another is used for its pattern only") {
  using namespace systems;
  const sparse a = grid(9), b = sparse(3 * grid(9)), other = from(2, 2, {{0, 0, 2.0}, {1, 0, 1.0}, {0, 1, 1.0}, {1, 1, 2.0}});
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(a.rows(), 1, 2);
  ldlt first, second, none;
  first.factorize(a);
  second.factorize(other);
  second.use_order_of(first);
  for (const int n : {0, 1, 2, 81}) CHECK_THROWS_WITH_AS(second.solve(Eigen::VectorXd::Ones(n)), doctest::Contains("without a factorised"), solver_error);
  for ([[maybe_unused]] const int twice : {0, 1}) {
    second.factorize(b);
    CHECK(distance(3 * second.solve(right), first.solve(right)) < 1e-12);
  }
  second.factorize(other);
  CHECK(distance(other * second.solve(Eigen::VectorXd::Ones(2)), Eigen::VectorXd::Ones(2)) < 1e-14);
  second.use_order_of(none);
  second.factorize(a);
  CHECK(second.solve(right) == first.solve(right));
  second.use_order_of(first);
  CHECK(!second.factorize_within(a, 5));
  CHECK_THROWS_AS(second.solve(right), solver_error);
  second.factorize(a);
  CHECK(second.solve(right) == first.solve(right));
  ldlt third;
  third.use_order_of(first);
  CHECK(!third.factorize_within(a, 5));
  CHECK(third.factorize_within(a, 1'000'000));
  CHECK(third.solve(right) == first.solve(right));
  first.use_order_of(first);
  CHECK_THROWS_AS(first.solve(right), solver_error);
  first.factorize(a);
  CHECK(first.solve(right) == third.solve(right));
}
