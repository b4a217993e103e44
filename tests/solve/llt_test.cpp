#include <concino/solve/llt.hpp>

#include <support/systems.hpp>

using namespace concino;
using namespace systems;

TEST_CASE("llt: fulfils the laws of solvers") {
  llt solver;
  check_solver(solver, 40);
}

TEST_CASE("llt: scales with the matrix") {
  llt solver;
  solver.factorize(grid(5));
  const Eigen::VectorXd b = random_vector(25), x = solver.solve(b);
  solver.factorize(grid(5) * 0x1p20);
  CHECK(solver.solve(b) == x * 0x1p-20);
}

TEST_CASE("llt: reads only the lower triangle") {
  llt solver;
  solver.factorize(grid(6).triangularView<Eigen::Lower>());
  const Eigen::VectorXd x = random_vector(36);
  CHECK(distance(solver.solve(grid(6) * x), x) < 1e-12);
}

TEST_CASE("llt: indefinite and singular matrices are errors that name the row") {
  llt solver;
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {1, 1, -2.0}, {2, 2, 1.0}})),
                       "llt: the matrix is not positive definite in row 1: elimination turns the diagonal entry -2 into -2", solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(2, 2, {{0, 0, 1.0}, {1, 0, 2.0}, {0, 1, 2.0}, {1, 1, 1.0}})), doctest::Contains("into -3"),
                       solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {2, 2, 1.0}})), doctest::Contains("to working precision in row 1"), solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(grid(4, 0)), doctest::Contains("not positive definite"), solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(1, 1, {{0, 0, -2.0}})), doctest::Contains("in row 0: elimination turns the diagonal entry -2 into -2"), solver_error);
  const double near = 1 + 0x1p-52;  // the pivot after elimination is a rounding error
  CHECK_THROWS_WITH_AS(solver.factorize(from(2, 2, {{0, 0, 1.0}, {1, 0, 1.0}, {0, 1, 1.0}, {1, 1, near}})), doctest::Contains("to working precision in row"),
                       solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(4, 4, {{0, 0, 1.0}, {1, 1, 1.0}, {2, 2, 1.0}, {3, 2, 1.0}, {2, 3, 1.0}, {3, 3, near}})),
                       doctest::Contains("to working precision in row"), solver_error);
  solver.factorize(grid(4));  // after a failed factorisation of the same pattern
  CHECK(distance(grid(4) * solver.solve(Eigen::VectorXd::Ones(16)), Eigen::VectorXd::Ones(16)) < 1e-12);
}
