#include <concino/solve/conjugate_gradients.hpp>

#include "support/systems.hpp"

#include <algorithm>
#include <random>

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

TEST_CASE("conjugate_gradients: few iterations in any order of rows, and where sums of rows are negative") {
  std::vector<int> place(2500);
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = static_cast<int>(i);
  std::shuffle(place.begin(), place.end(), std::mt19937(2));
  const sparse ordered = grid(50, 1e-3);
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < 2500; ++c)
    for (sparse::InnerIterator it(ordered, c); it; ++it)
      entries.emplace_back(place[static_cast<std::size_t>(it.row())], place[static_cast<std::size_t>(c)], it.value());
  conjugate_gradients solver;
  for (const sparse& a : {ordered, from(2500, 2500, entries)}) {
    solver.factorize(a);
    CHECK(solver.has_pattern_of(a));
    solver.solve(random_vector(2500));
    CHECK(solver.iterations() < 80);
  }
  const sparse square = grid(12) * grid(12);  // entries of either sign: the first factorisations fail
  solver.factorize(square);
  const Eigen::VectorXd x = random_vector(144);
  CHECK(distance(solver.solve(square * x), x) < 1e-8);
  const sparse near_singular = from(2, 2, {{0, 0, 1.0}, {1, 0, 1 - 1e-9}, {0, 1, 1 - 1e-9}, {1, 1, 1.0}});
  solver.factorize(near_singular);
  CHECK(distance(near_singular * solver.solve(Eigen::Vector2d(1, 3)), Eigen::Vector2d(1, 3)) < 1e-5);
}

TEST_CASE("conjugate_gradients: another one like it, and copies") {
  conjugate_gradients one({.tolerance = 1e-4, .max_iterations = 70});
  const conjugate_gradients another(one.options());
  CHECK(another.options().tolerance == 1e-4);
  CHECK(another.options().max_iterations == 70);
  one.factorize(grid(9));
  const conjugate_gradients copy = one;
  const Eigen::VectorXd b = random_vector(81), x = one.solve(b);
  one.factorize(grid(4));
  CHECK(copy.solve(b) == x);
}

TEST_CASE("conjugate_gradients: options out of their range") {
  for (const double tolerance : {0.0, 1.0, -1.0, std::nan("")}) CHECK_THROWS_AS(conjugate_gradients({.tolerance = tolerance}), invalid_argument);
  CHECK_THROWS_AS(conjugate_gradients({.max_iterations = -1}), invalid_argument);
}
