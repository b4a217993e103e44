#include <concino/solve/solve_columns.hpp>

#include <concino/solve/ldlt.hpp>

#include <support/systems.hpp>

using namespace concino;
using namespace systems;

TEST_CASE("solve_columns: equals solve for each column") {
  ldlt solver;
  solver.factorize(grid(5));
  Eigen::MatrixXd b(25, 4);
  for (int c = 0; c < 4; ++c) b.col(c) = random_vector(25, static_cast<unsigned>(c));
  const Eigen::MatrixXd x = solve_columns(solver, b);
  for (int c = 0; c < 4; ++c) CHECK(x.col(c) == solver.solve(b.col(c)));
  CHECK(solve_columns(solver, Eigen::MatrixXd(25, 0)).cols() == 0);
  CHECK_THROWS_AS(solve_columns(solver, Eigen::MatrixXd::Zero(24, 1)), solver_error);
}
