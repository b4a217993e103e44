#include <concino/adapters/cholmod.hpp>

#include <concino/solve/llt.hpp>

#include <support/solver_paths.hpp>
#include <support/systems.hpp>

#include <cstddef>
#include <vector>

using namespace concino;
using namespace systems;

TEST_CASE("cholmod: fulfils the laws of solvers") {
  cholmod solver;
  check_solver(solver, 40);
}

TEST_CASE("cholmod: reads only the lower triangle, and agrees with Eigen") {
  cholmod solver;
  llt other;
  solver.factorize(grid(50).triangularView<Eigen::Lower>());
  other.factorize(grid(50));
  const Eigen::VectorXd b = random_vector(2500);
  CHECK(distance(solver.solve(b), other.solve(b)) < 1e-12);
}

TEST_CASE("cholmod: indefinite and singular matrices are errors that name the row") {
  cholmod solver;
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {1, 1, -2.0}, {2, 2, 1.0}})),
                       "cholmod: the matrix is not positive definite in row 1: elimination turns the diagonal entry -2 into one that is not positive", solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {2, 2, 1.0}})), doctest::Contains("in row 1"), solver_error);
  for (const int n : {4, 30}) CHECK_THROWS_WITH_AS(solver.factorize(grid(n, 0)), doctest::Contains("not positive definite"), solver_error);
  solver.factorize(grid(30));  // after a failed factorisation of the same pattern
  CHECK(distance(grid(30) * solver.solve(Eigen::VectorXd::Ones(900)), Eigen::VectorXd::Ones(900)) < 1e-11);
}

TEST_CASE("cholmod: chooses the elimination order, and keeps it for other values") {
  const int n = 1200;  // every unknown is coupled with every other
  sparse a(n, n);
  a.reserve(Eigen::VectorXi::Constant(n, n));
  for (int c = 0; c < n; ++c)
    for (int r = 0; r < n; ++r) a.insert(r, c) = r == c ? n + c : 1.0 / (1 + r + c);
  const Eigen::VectorXd x = random_vector(n);
  cholmod solver;
  for (const double scale : {1.0, 0x1p-30}) {
    solver.factorize(a * scale);
    CHECK(distance(solver.solve(a * x * scale), x) < 1e-12);
  }
  solver.factorize(grid(20));
  CHECK(distance(grid(20) * solver.solve(Eigen::VectorXd::Ones(400)), Eigen::VectorXd::Ones(400)) < 1e-12);
}

TEST_CASE("cholmod: handles small, singular and indefinite systems, and isolated verts") {
  solver_paths::check_all(solver_paths::any_solver::make<cholmod>(), solver_paths::indefinite::refused);
}

TEST_CASE("cholmod: takes the order that it is given") {
  const elimination_ordering backwards = [](const Eigen::SparseMatrix<double>& matrix) {
    std::vector<int> order(static_cast<std::size_t>(matrix.cols()));
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(order.size() - 1 - i);
    return order;
  };
  cholmod solver({.ordering = backwards}), automatic;
  check_solver(solver, 40);
  CHECK((solver.options().ordering == backwards));
  for (const int n : {3, 30}) {
    solver.factorize(grid(n));
    automatic.factorize(grid(n));
    const Eigen::VectorXd b = random_vector(n * n);
    CHECK(distance(solver.solve(b), automatic.solve(b)) < 1e-12);
  }
  cholmod too_few({.ordering = [](const Eigen::SparseMatrix<double>&) { return std::vector<int>{0}; }}),
      twice({.ordering = [](const Eigen::SparseMatrix<double>&) { return std::vector<int>{0, 0, 1, 2}; }});
  CHECK_THROWS_AS(too_few.factorize(grid(2)), invalid_argument);
  CHECK_THROWS_AS(twice.factorize(grid(2)), solver_error);
}
