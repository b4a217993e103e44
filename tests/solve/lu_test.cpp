#include <concino/solve/lu.hpp>

#include <support/systems.hpp>

#include <Eigen/Dense>

using namespace concino;
using namespace systems;

TEST_CASE("lu: fulfils the laws of solvers") {
  lu solver;
  check_solver(solver, 30);
  check_scaling(solver);
}

TEST_CASE("lu: agrees with a dense solver on unsymmetric and indefinite matrices") {
  std::mt19937 random(11);
  lu solver;
  for (int round = 0; round < 60; ++round) {
    const int n = 1 + static_cast<int>(random() % 30);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i) entries.emplace_back(i, (i + 1) % n, 2.0);  // the diagonal is empty, so rows must be exchanged
    for (int k = 0; k < 2 * n; ++k)
      entries.emplace_back(static_cast<int>(random()) & 1 ? k % n : (k * 7) % n, static_cast<int>(random() % 1000) % n,
                           static_cast<double>(random() % 100) / 1000);
    const sparse a = from(n, n, entries);
    const Eigen::FullPivLU<Eigen::MatrixXd> dense((Eigen::MatrixXd(a)));
    if (dense.rcond() < 1e-6) continue;
    const Eigen::VectorXd b = random_vector(n);
    solver.factorize(a);
    CHECK(distance(solver.solve(b), dense.solve(b)) < 1e-7);
    CHECK(distance(a * solver.solve(b), b) < 1e-9);
  }
  const sparse a = grid(20, 0.1, 0.4);
  solver.factorize(a);
  const Eigen::VectorXd x = random_vector(400);
  CHECK(distance(solver.solve(a * x), x) < 1e-10);
}

TEST_CASE("lu: singular matrices are errors that name a column") {
  lu solver;
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {1, 2, 2.0}, {2, 2, 1.0}})),
                       doctest::Contains("singular in column 1: it is 0"), solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {0, 1, 1.0}, {2, 2, 1.0}})),
                       doctest::Contains("is a combination of others"), solver_error);
  for (const int n : {2, 10, 40}) CHECK_THROWS_WITH_AS(solver.factorize(grid(n, 0)), doctest::Contains("singular in column"), solver_error);
}

TEST_CASE("lu: solves systems with different units of unknowns and equations") {
  lu solver;
  const sparse a = grid(4, 0.5, 0.2);
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < 16; ++c)
    for (sparse::InnerIterator it(a, c); it; ++it)
      entries.emplace_back(static_cast<int>(it.row()), c, std::ldexp(it.value(), 20 * (static_cast<int>(it.row()) % 2) - 30 * (c % 3)));
  solver.factorize(from(16, 16, entries));
  const Eigen::VectorXd x = random_vector(16), b = a * x;
  Eigen::VectorXd scaled = b;
  for (int i = 0; i < 16; ++i) scaled[i] = std::ldexp(b[i], 20 * (i % 2));
  const Eigen::VectorXd y = solver.solve(scaled);
  for (int i = 0; i < 16; ++i) CHECK(std::abs(std::ldexp(y[i], -30 * (i % 3)) - x[i]) < 1e-12);
}

TEST_CASE("lu: solves systems with entries of extremely different size") {
  lu solver;
  for (const int apart : {900, 1000, 1020, 1030}) {
    const double large = std::ldexp(1.0, apart / 2 + 85), small = std::ldexp(large, -apart);
    solver.factorize(from(2, 2, {{0, 0, small}, {1, 1, large}}));
    CHECK(solver.solve(Eigen::Vector2d(3 * small, large)) == Eigen::Vector2d(3, 1));
  }
}
