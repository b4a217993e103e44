#include <concino/solve/qr.hpp>

#include <support/systems.hpp>

#include <Eigen/Dense>

using namespace concino;
using namespace systems;

TEST_CASE("qr: fulfils the laws of solvers on square systems") {
  qr solver;
  check_solver(solver, 8, 0.1);
  solver.factorize(grid(5, 0.1, 0.4));
  const Eigen::VectorXd x = random_vector(25);
  CHECK(distance(solver.solve(grid(5, 0.1, 0.4) * x), x) < 1e-12);
}

TEST_CASE("qr: least squares agree with a dense solver, with zero rows and columns in any unit") {
  const int n = 12;
  std::mt19937 random(5);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < 3 * n; ++i)
    if (i % 5 != 2)
      for (const int c : {i % n, static_cast<int>(random() % n), static_cast<int>(random() % n)})
        entries.emplace_back(i, c, std::ldexp(1.0 + static_cast<double>(random() % 7), 9 * c));
  const sparse a = from(3 * n, n, entries);
  qr solver;
  solver.factorize(a);
  const Eigen::VectorXd b = random_vector(3 * n), x = solver.solve(b);
  const Eigen::VectorXd gradient = Eigen::MatrixXd(a).transpose() * (b - a * x);
  for (int c = 0; c < n; ++c) CHECK(std::abs(gradient[c]) < 1e-12 * Eigen::MatrixXd(a).col(c).norm());
}

TEST_CASE("qr: dependent columns, or more columns than rows, are errors") {
  qr solver;
  CHECK_THROWS_WITH_AS(solver.factorize(from(4, 2, {{0, 0, 1.0}, {0, 1, 2.0}, {3, 0, 2.0}, {3, 1, 4.0}})),
                       doctest::Contains("is a combination of others"),
                       solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(4, 3, {{0, 0, 1.0}, {0, 2, 2.0}, {3, 0, 2.0}, {3, 2, 5.0}})),
                       doctest::Contains("column 1 of the matrix"), solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(1, 2, {{0, 0, 1.0}})), doctest::Contains("at least as many rows as columns"), solver_error);
  CHECK_THROWS_AS(solver.factorize(grid(5, 0)), solver_error);
  // more columns than rows with entries
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 1, 1.0}, {1, 2, 1.0}})), doctest::Contains("column 0 of the matrix"), solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {1, 2, 1.0}})), doctest::Contains("column 1 of the matrix"), solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {1, 1, 1.0}})), doctest::Contains("column 2 of the matrix"), solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {2, 1, 1.0}, {2, 2, 1.0}})), doctest::Contains("column 2 of the matrix"), solver_error);
}
