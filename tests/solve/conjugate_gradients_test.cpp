#include <concino/solve/conjugate_gradients.hpp>

#include "support/systems.hpp"

using namespace concino;
using namespace systems;

TEST_CASE("conjugate_gradients: solves, and says what it cannot") {
  conjugate_gradients solver;
  check_solver(solver, 40);
  check_scaling(solver);
}

TEST_CASE("conjugate_gradients: iterations and residual of the last solve, and the tolerance asked for") {
  conjugate_gradients fine, coarse({.tolerance = 1e-3});
  fine.factorize(grid(30, 0.01));
  coarse.factorize(grid(30, 0.01));
  const Eigen::VectorXd b = random_vector(900), x = fine.solve(b), y = coarse.solve(b);
  CHECK((b - grid(30, 0.01) * x).norm() / b.norm() == doctest::Approx(fine.residual()));
  CHECK(fine.residual() < 2e-12);
  CHECK(coarse.residual() < 1.1e-3);
  CHECK(coarse.residual() > 1e-8);
  CHECK(coarse.iterations() < fine.iterations());
  fine.solve(Eigen::VectorXd::Zero(900));
  CHECK(fine.iterations() == 0);
  CHECK(fine.residual() == 0);
}

TEST_CASE("conjugate_gradients: reads the lower triangle only") {
  conjugate_gradients solver;
  solver.factorize(grid(6).triangularView<Eigen::Lower>());
  const Eigen::VectorXd x = random_vector(36);
  CHECK(distance(solver.solve(grid(6) * x), x) < 1e-10);
}

TEST_CASE("conjugate_gradients: what does not converge, and what cannot be definite") {
  conjugate_gradients few({.max_iterations = 3}), solver;
  few.factorize(grid(30, 0.01));
  CHECK_THROWS_WITH_AS(few.solve(random_vector(900)), doctest::Contains("not converged after 3 iterations: the residual is "), solver_error);
  CHECK(few.iterations() == 3);
  CHECK(few.residual() > 1e-12);
  CHECK_THROWS_WITH_AS(solver.factorize(from(2, 2, {{0, 0, 1.0}, {1, 1, -1.0}})),
                       doctest::Contains("the diagonal entry of row 1 is -1"), solver_error);
  solver.factorize(grid(6, 0));  // singular: not for every right-hand side
  CHECK_THROWS_WITH_AS(solver.solve(Eigen::VectorXd::Ones(36)), doctest::Contains("not converged"), solver_error);
}

TEST_CASE("conjugate_gradients: options out of their range") {
  for (const double tolerance : {0.0, 1.0, -1.0, std::nan("")}) CHECK_THROWS_AS(conjugate_gradients({.tolerance = tolerance}), invalid_argument);
  CHECK_THROWS_AS(conjugate_gradients({.max_iterations = -1}), invalid_argument);
}
