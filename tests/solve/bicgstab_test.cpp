#include <concino/solve/bicgstab.hpp>

#include "support/systems.hpp"

using namespace concino;
using namespace systems;

TEST_CASE("bicgstab: solves, and says what it cannot") {
  bicgstab solver;
  check_solver(solver, 30);
  check_scaling(solver);
}

TEST_CASE("bicgstab: unsymmetric systems, iterations and residual") {
  bicgstab solver({.drop = 0.1, .fill = 2});
  const sparse a = grid(20, 0.2, 0.4);
  solver.factorize(a);
  const Eigen::VectorXd x = random_vector(400);
  CHECK(distance(solver.solve(a * x), x) < 1e-9);
  CHECK(solver.iterations() > 0);
  CHECK(solver.residual() < 1e-11);
}

TEST_CASE("bicgstab: singular matrices, and what does not converge") {
  bicgstab solver, one({.max_iterations = 1, .drop = 0.5, .fill = 1});
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {0, 1, 1.0}, {2, 2, 1.0}})), doctest::Contains("row 1 is 0"), solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {1, 0, 1.0}, {2, 2, 1.0}})), doctest::Contains("column 1 is 0"), solver_error);
  solver.factorize(grid(10, 0));
  CHECK_THROWS_WITH_AS(solver.solve(Eigen::VectorXd::Ones(100)), doctest::Contains("not converged"), solver_error);
  one.factorize(grid(20, 0.01, 0.4));
  CHECK_THROWS_WITH_AS(one.solve(random_vector(400)), doctest::Contains("not converged after 1 iterations: the residual is "), solver_error);
}

TEST_CASE("bicgstab: options out of their range") {
  for (const double bad : {1.0, -1.0, std::nan("")}) {
    CHECK_THROWS_AS(bicgstab({.tolerance = bad}), invalid_argument);
    CHECK_THROWS_AS(bicgstab({.drop = bad}), invalid_argument);
  }
  CHECK_THROWS_AS(bicgstab({.max_iterations = -1}), invalid_argument);
  CHECK_THROWS_AS(bicgstab({.fill = 0}), invalid_argument);
}
