#include <concino/core/residual.hpp>

#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/systems.hpp>

#include <optional>

using namespace concino;
using namespace systems;

namespace {

/// Returns the solution of diag(d) x = b times `factor`, and counts the calls.
struct wrong_solver {
  double factor = 1;
  Eigen::VectorXd d = Eigen::Vector3d(2, 4, 8);
  mutable int solves = 0;
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    ++solves;
    return factor * b.cwiseQuotient(d);
  }
};
struct wrong_iteration : wrong_solver {
  bool is_iterative() const { return true; }
};
struct wrong_iteration_that_tells : wrong_iteration {
  double told = 0;
  double residual() const { return told; }
};

sparse diagonal() { return from(3, 3, {{0, 0, 2.0}, {1, 1, 4.0}, {2, 2, 8.0}}); }
Eigen::VectorXd right() { return Eigen::Vector3d(2, -4, 16); }

}  // namespace

TEST_CASE("residual: is relative to the terms of each row, of a full matrix or a lower triangle") {
  const sparse a = from(3, 3, {{0, 0, 4.0}, {1, 0, -1.0}, {0, 1, -1.0}, {1, 1, 3.0}, {2, 1, -2.0}, {1, 2, -2.0}, {2, 2, 5.0}});
  const Eigen::VectorXd x = Eigen::Vector3d(1, -2, 3), exact = a * x;  // a x = 6, -13, 19; the absolute values of the terms sum to 6, 13 and 19
  const sparse lower = a.triangularView<Eigen::Lower>();
  for (int row = 0; row < 3; ++row)
    for (const double off : {-0.5, 0.25}) {
      Eigen::VectorXd b = exact, r;
      b[row] += off;
      const double terms = std::abs(exact[row]), expected = std::abs(off) / (std::abs(b[row]) + terms);
      for (const bool is_lower : {false, true}) {
        CHECK(core::residual(is_lower ? lower : a, x, b, r, is_lower) == doctest::Approx(expected).epsilon(1e-14));
        CHECK(r == b - exact);
        const double largest[] = {4, 3, 5};
        CHECK(core::residual_beside_largest(is_lower ? lower : a, x, b, r, is_lower) ==
              doctest::Approx(std::abs(off) / (std::abs(b[row]) + largest[row] * 3)).epsilon(1e-14));
      }
    }
}

TEST_CASE("residual: finds the largest entry in both triangles, and the largest unknown") {
  const sparse a = from(3, 3, {{0, 0, 1.0}, {1, 0, -9.0}, {0, 1, -9.0}, {1, 1, 2.0}, {2, 2, 3.0}}), lower = a.triangularView<Eigen::Lower>();
  for (int largest = 0; largest < 3; ++largest)
    for (int row = 0; row < 3; ++row) {
      Eigen::VectorXd x = Eigen::Vector3d::Ones(), r = Eigen::Vector3d::Zero();
      x[largest] = -8;
      r[row] = 0.5;
      const Eigen::VectorXd b = Eigen::Vector3d(1, 2, 3);
      const double expected = 0.5 / (b[row] + (row < 2 ? 9 : 3) * 8);
      CHECK(core::residual_beside_largest(a, x, b, r, false) == doctest::Approx(expected).epsilon(1e-14));
      CHECK(core::residual_beside_largest(lower, x, b, r, true) == doctest::Approx(expected).epsilon(1e-14));
    }
  // The largest entry of row 1 is above the diagonal, where the lower triangle alone does not contain it.
  Eigen::VectorXd r = Eigen::Vector3d(0.5, 0, 0), zero = Eigen::Vector3d::Zero(), small = Eigen::Vector3d::Constant(0.25);
  CHECK(core::residual_beside_largest(lower, small, zero, r, false) == 0.5 / 0.25);
  CHECK(core::residual_beside_largest(lower, small, zero, r, true) == 0.5 / (9 * 0.25));
}

TEST_CASE("residual: is 0 for rows of zeros, and never small for NaN") {
  const sparse a = from(3, 3, {{0, 0, 1.0}});
  Eigen::VectorXd x = Eigen::Vector3d(2, 5, 7), b = Eigen::Vector3d(2, 0, 0), r;
  CHECK(core::residual(a, x, b, r, false) == 0);
  CHECK(core::residual_beside_largest(a, x, b, r, false) == 0);
  x[0] = std::nan("");
  CHECK(std::isnan(core::residual(a, x, b, r, false)));
  CHECK(std::isnan(core::residual_beside_largest(a, x, b, r, false)));
}

TEST_CASE("core::solve_and_check: knows which solvers iterate") {
  CHECK(!core::is_iterative(ldlt()));
  CHECK(core::is_iterative(conjugate_gradients()));
  CHECK(!core::is_iterative(wrong_solver()));
  CHECK(core::is_iterative(wrong_iteration()));
}

TEST_CASE("core::solve_and_check: corrects the solution at most three times") {
  const wrong_solver exact;
  CHECK(core::solve_and_check(exact, diagonal(), right(), "x") == Eigen::Vector3d(1, -1, 2));
  CHECK(exact.solves == 1);
  const wrong_solver near{.factor = 0.99};  // the errors are 1e-2, 1e-4, 1e-6, 1e-8
  CHECK(distance(core::solve_and_check(near, diagonal(), right(), "x"), Eigen::Vector3d(1, -1, 2)) < 3e-8);
  CHECK(near.solves == 4);
  const wrong_solver nearer{.factor = 1 + 1e-7};
  CHECK(distance(core::solve_and_check(nearer, diagonal(), right(), "x", false), Eigen::Vector3d(1, -1, 2)) < 1e-13);
  CHECK(nearer.solves == 2);
  CHECK_THROWS_WITH_AS(core::solve_and_check(wrong_solver{.factor = 0.9}, diagonal(), right(), "x"), doctest::Contains("the relative residual is"), solver_error);
  const wrong_solver away{.factor = 3};  // corrections increase the error
  CHECK_THROWS_AS(core::solve_and_check(away, diagonal(), right(), "x"), solver_error);
  CHECK(away.solves == 2);
}

TEST_CASE("core::solve_and_check: trusts the residual of iterative solvers, without corrections") {
  const auto check = [](double factor, std::optional<double> told) {
    const sparse one = from(1, 1, {{0, 0, 1.0}});
    const Eigen::VectorXd d = Eigen::VectorXd::Ones(1);
    const auto run = [&](auto solver) {
      solver.factor = factor;
      solver.d = d;
      try {
        core::solve_and_check(solver, one, d, "x");
      } catch (const solver_error&) {
        CHECK(solver.solves == 1);
        return false;
      }
      CHECK(solver.solves == 1);
      return true;
    };
    if (!told) return run(wrong_iteration());
    wrong_iteration_that_tells solver;
    solver.told = *told;
    return run(solver);
  };
  // the residual is |1 - f| / (1 + |f|)
  CHECK(check(1 - 1.9e-5, {}));
  CHECK(!check(1 - 2.1e-5, {}));
  CHECK(!check(0.5, {}));
  CHECK(check(1 - 1.9e-5, 0));
  CHECK(!check(1 - 2.1e-5, 0));
  CHECK(check(0, 0.1));
  CHECK(!check(0, 0.095));
  CHECK(!check(std::nan(""), 1));
}
