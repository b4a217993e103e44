#include <concino/solve/bicgstab.hpp>

#include <support/systems.hpp>

#include <string>
#include <vector>

using namespace concino;
using namespace systems;

TEST_CASE("bicgstab: fulfils the laws of solvers") {
  bicgstab solver;
  check_solver(solver, 30);
  check_scaling(solver);
}

TEST_CASE("bicgstab: solves unsymmetric systems, and reports iterations and residual") {
  bicgstab solver({.drop = 0.1, .fill = 2});
  const sparse a = grid(20, 0.2, 0.4);
  solver.factorize(a);
  const Eigen::VectorXd x = random_vector(400);
  CHECK(distance(solver.solve(a * x), x) < 1e-9);
  CHECK(solver.iterations() > 0);
  CHECK(solver.residual() < 1e-11);
}

TEST_CASE("bicgstab: singular matrices and missing convergence are errors") {
  bicgstab solver, one({.max_iterations = 1, .drop = 0.5, .fill = 1});
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {0, 1, 1.0}, {2, 2, 1.0}})), doctest::Contains("row 1 is 0"), solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {1, 0, 1.0}, {2, 2, 1.0}})), doctest::Contains("column 1 is 0"), solver_error);
  solver.factorize(grid(10, 0));
  CHECK_THROWS_WITH_AS(solver.solve(Eigen::VectorXd::Ones(100)), doctest::Contains("not converged"), solver_error);
  one.factorize(grid(20, 0.01, 0.4));
  CHECK_THROWS_WITH_AS(one.solve(random_vector(400)), doctest::Contains("not converged after 1 iterations: the residual is "), solver_error);
}

TEST_CASE("bicgstab: a missed tolerance is an error, or by option a flag") {
  const sparse a = grid(30, 0.01, 0.4);
  const Eigen::VectorXd b = random_vector(900);
  bicgstab few({.max_iterations = 2, .drop = 0.5, .fill = 1}), flagged({.max_iterations = 2, .drop = 0.5, .fill = 1, .accept_missed_tolerance = true});
  few.factorize(a);
  flagged.factorize(a);
  CHECK_THROWS_WITH_AS(few.solve(b), doctest::Contains("not converged after 2 iterations"), solver_error);
  const Eigen::VectorXd x = flagged.solve(b);
  CHECK_FALSE(flagged.has_converged());
  CHECK(flagged.residual() > 1e-12);
  CHECK(flagged.residual() <= 1);
  for (const double scale : {1.0, 1e150}) {  // singular; numbers may overflow during the iteration
    std::vector<Eigen::Triplet<double>> entries{{0, 0, 1.0}, {0, 1, 1.0}, {1, 0, scale}, {1, 1, scale}, {2, 2, 1.0}};
    bicgstab singular;
    std::string said = "solved";
    try {
      singular.factorize(from(3, 3, entries));
      singular.solve(Eigen::Vector3d(1, 3 * scale, 1));
    } catch (const solver_error& e) {
      said = e.what();
    }
    CHECK(said.find("bicgstab: ") == 0);
    CHECK(said.find("nan") == std::string::npos);
  }
}

TEST_CASE("bicgstab: the reported residual is never NaN, even after overflow") {
  const auto said = [](const sparse& a, const Eigen::VectorXd& b) -> std::string {
    bicgstab solver;
    try {
      solver.factorize(a);
      const Eigen::VectorXd x = solver.solve(b);
      CHECK(x.allFinite());
      CHECK(solver.residual() <= 1e-12);
    } catch (const solver_error& e) {
      return e.what();
    }
    return "solved";
  };
  for (const std::string& s : {said(from(2, 2, {{0, 0, 1e150}, {0, 1, 1e150}, {1, 0, 1e200}, {1, 1, 1e-200}}), Eigen::Vector2d(3, 3)),
                               said(from(2, 2, {{0, 0, 1e100}, {1, 0, 1e150}, {1, 1, 1e-320}}), Eigen::Vector2d(0, 1e150)),
                               said(from(2, 2, {{0, 0, 1e150}, {1, 0, 3.0}, {1, 1, 1e-300}}), Eigen::Vector2d(-1, 1e300)),
                               said(from(2, 2, {{0, 0, 2.0}, {1, 1, 1e-320}}), Eigen::Vector2d(1e150, 1e300))}) {
    CAPTURE(s);
    CHECK((s == "solved" || s.find("bicgstab: ") == 0));
    CHECK(s.find("nan") == std::string::npos);
  }
}

TEST_CASE("bicgstab: large entries of some rows do not hide the others") {
  const int n = 30;
  sparse a = grid(n, 0, 0.1);
  Eigen::VectorXd x(n * n);
  for (int i = 0; i < n * n; ++i) {
    x[i] = std::sin(0.1 * (i % n)) + 0.02 * (i / n);
    if (i % n == 0 || i % n == n - 1) a.coeffRef(i, i) += 1e12;
  }
  bicgstab solver;
  solver.factorize(a);
  CHECK(distance(solver.solve(a * x), x) < 1e-9);
  CHECK(solver.has_converged());
}

TEST_CASE("bicgstab: options out of range throw") {
  for (const double bad : {1.0, -1.0, std::nan("")}) {
    CHECK_THROWS_AS(bicgstab({.tolerance = bad}), invalid_argument);
    CHECK_THROWS_AS(bicgstab({.drop = bad}), invalid_argument);
  }
  CHECK_THROWS_AS(bicgstab({.max_iterations = -1}), invalid_argument);
  CHECK_THROWS_AS(bicgstab({.fill = 0}), invalid_argument);
}
