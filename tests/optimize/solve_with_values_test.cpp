#include <concino/optimize/solve_with_values.hpp>

#include <concino/solve/auto_solver.hpp>
#include <concino/solve/bicgstab.hpp>
#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/ldlt.hpp>
#include <concino/solve/llt.hpp>
#include <concino/solve/lu.hpp>
#include <concino/solve/qr.hpp>

#include <support/systems.hpp>

#include <utility>

using namespace concino;
using namespace systems;

namespace {

using values = std::vector<std::pair<int, double>>;

/// A solver whose solutions have one entry that is NaN.
struct broken_solver : ldlt {
  int entry = 0;
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    Eigen::VectorXd x = ldlt::solve(b);
    x[entry] = std::nan("");
    return x;
  }
};

/// Checks that prescribed values are exact, and that the other equations hold.
void check_conditions(const sparse& a, const Eigen::VectorXd& b, const values& given, const Eigen::VectorXd& x) {
  Eigen::VectorXd r = b - a * x;
  for (const auto& [i, v] : given) {
    CHECK(x[i] == v);
    r[i] = 0;
  }
  CHECK(r.cwiseAbs().maxCoeff() < 1e-10);
}

}  // namespace

TEST_CASE("solve_with_values: a path between two prescribed ends is a line") {
  sparse path(5, 5);
  for (int i = 0; i < 5; ++i) {
    path.coeffRef(i, i) = i % 4 ? 2 : 1;
    if (i > 0) path.coeffRef(i, i - 1) = path.coeffRef(i - 1, i) = -1;
  }
  const Eigen::VectorXd x = solve_with_values(path, Eigen::VectorXd::Zero(5), {{0, 1.0}, {4, 3.0}});
  for (int i = 0; i < 5; ++i) CHECK(x[i] == doctest::Approx(1 + i / 2.0));
  CHECK_THROWS_WITH_AS(solve_with_values(path, Eigen::VectorXd::Zero(5), {}), doctest::Contains("singular"), solver_error);  // constants are the kernel
}

TEST_CASE("solve_with_values: works with every solver, at any size, for any prescribed unknowns") {
  for (const int n : {2, 9}) {
    const sparse a = grid(n, 0);  // singular without prescribed values
    const Eigen::VectorXd b = random_vector(n * n);
    values all, some{{1, 0.25}, {n * n - 1, -3}, {1, 0.25}}, one{{0, 0x1p10}};
    for (int i = 0; i < n * n; ++i) all.emplace_back(i, 0.5 * i);
    for (const values& given : {all, some, one}) {
      const auto check = [&](auto&& solver) { check_conditions(a, b, given, solve_with_values(a, b, given, solver)); };
      if (given.back().second != 0x1p10) check(conjugate_gradients{});
      check(auto_solver{});
      check(ldlt{});
      check(llt{});
      check(lu{});
      check(qr{});
    }
    check_conditions(a, b, some, solve_with_values(a, b, some, auto_solver({.max_factor_entries = 0})));
    check_conditions(a, b, some, solve_with_values(a, b, some, bicgstab{}));
  }
}

TEST_CASE("solve_with_values: unsymmetric systems work by lu, and throw by a solver of one triangle") {
  const sparse a = grid(6, 0.1, 0.4);
  const Eigen::VectorXd b = random_vector(36);
  const values given{{7, 2.0}, {30, -1.0}};
  check_conditions(a, b, given, solve_with_values(a, b, given, lu{}));
  CHECK_THROWS_WITH_AS(solve_with_values(a, b, given), doctest::Contains("solve_with_values: "), solver_error);
  sparse less = grid(6, 1.0);
  less.coeffRef(0, 1) = 0;
  CHECK_THROWS_WITH_AS(solve_with_values(less, b, given), doctest::Contains("the solver is not made for such a system"), solver_error);
  CHECK_THROWS_WITH_AS(solve_with_values(less, b, given, conjugate_gradients{}), doctest::Contains("the solver is not made for such a system"), solver_error);
  check_conditions(less, b, given, solve_with_values(less, b, given, lu{}));
}

TEST_CASE("solve_with_values: accepts no values and uncompressed, empty and scaled matrices") {
  sparse a = grid(4);
  const Eigen::VectorXd x = random_vector(16);
  CHECK(distance(solve_with_values(a, a * x, {}), x) < 1e-13);
  const Eigen::VectorXd b = random_vector(16), y = solve_with_values(a, b, {{3, 2.0}});
  for (const double s : {0x1p-300, 0x1p20, 0x1p100}) {
    CHECK(solve_with_values(a * s, b * s, {{3, 2.0}}) == y);
    CHECK(solve_with_values(a, b * s, {{3, 2.0 * s}}) == y * s);
  }
  a.uncompress();
  CHECK(solve_with_values(a, b, {{3, 2.0}}) == y);
  CHECK(solve_with_values(sparse(0, 0), Eigen::VectorXd(0), {}).size() == 0);
}

TEST_CASE("solve_with_values: the error names the invalid argument, and rows by their own numbers") {
  const sparse a = grid(2);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(4);
  CHECK_THROWS_WITH_AS(solve_with_values(sparse(3, 2), b, {}), doctest::Contains("3 rows and 2 columns"), solver_error);
  CHECK_THROWS_WITH_AS(solve_with_values(a, Eigen::VectorXd::Ones(3), {}), doctest::Contains("3 entries, the matrix 4 rows"), solver_error);
  CHECK_THROWS_WITH_AS(solve_with_values(a * std::nan(""), b, {}), doctest::Contains("not finite, in row 0, column 0"), solver_error);
  CHECK_THROWS_WITH_AS(solve_with_values(a, b * HUGE_VAL, {}), doctest::Contains("entry 0 of the right-hand side is not finite"), solver_error);
  CHECK_THROWS_WITH_AS(solve_with_values(a, b, {{4, 0.0}}), doctest::Contains("unknown 4, but there are 4"), invalid_argument);
  CHECK_THROWS_WITH_AS(solve_with_values(a, b, {{1, 0.0}, {1, 1.0}}), doctest::Contains("given two values, 0 and 1"), invalid_argument);
  CHECK_THROWS_WITH_AS(solve_with_values(a, b, {{1, HUGE_VAL}}), doctest::Contains("not finite"), invalid_argument);
  const sparse gap = from(4, 4, {{0, 0, 1.0}, {1, 1, 1.0}, {3, 3, 1.0}});
  CHECK_THROWS_WITH_AS(solve_with_values(gap, b, {{0, 1.0}}), doctest::Contains("singular to working precision in row 2"), solver_error);
  CHECK_THROWS_WITH_AS(solve_with_values(gap, b, {{0, 1.0}}, lu{}), doctest::Contains("column 2: it is 0"), solver_error);
  CHECK(solve_with_values(gap, b, {{2, 5.0}})[2] == 5);
}

TEST_CASE("solve_with_values: a solver that returns NaN is an error, in any row") {
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(16);
  for (int i = 0; i < 16; ++i) {
    broken_solver solver;
    solver.entry = i;
    const int given = i < 8 ? 15 : 0;
    CHECK_THROWS_WITH_AS(solve_with_values(grid(4), b, {{given, 1.0}}, solver), doctest::Contains("relative residual is nan"), solver_error);
  }
}

TEST_CASE("solve_with_values: right-hand sides of prescribed unknowns are ignored") {
  for (int largest = 0; largest < 4; ++largest)
    for (const double unit : {1.0, 0x1p-30, 0x1p30}) {
      std::vector<Eigen::Triplet<double>> entries;
      for (int i = 0; i < 4; ++i) entries.emplace_back(i, i, (i == largest ? -12.0 : 0.5 + i / 4.0) * unit);
      const sparse a = from(4, 4, entries);
      for (int given = 0; given < 4; ++given) {
        const detail::known_values problem("x", 4, values{{given, 7.0}});
        for (int i = 0; i < 4; ++i) CHECK(detail::without_known_values(problem, a).coeff(i, i) == (i == given ? 8 * unit : a.coeff(i, i)));
      }
    }
  const sparse a = grid(2);
  const Eigen::VectorXd b = Eigen::Vector4d(1, 2, 3, 4);
  for (int first = 0; first < 4; ++first)
    for (int second = 0; second < 4; ++second) {
      const detail::known_values problem("x", 4, values{{first, 2.0}, {second, 2.0}});
      Eigen::VectorXd expected = b - a * problem.x;
      expected[first] = expected[second] = 0;
      CHECK(detail::load_of_unknowns(problem, a, b) == expected);
    }
}

TEST_CASE("solve_with_values: works with one unknown, and with one that is not prescribed") {
  CHECK(solve_with_values(from(1, 1, {{0, 0, 2.0}}), Eigen::VectorXd::Constant(1, 4.0), {})[0] == 2);
  const sparse a = from(2, 2, {{0, 0, 2.0}, {1, 0, 1.0}, {0, 1, 1.0}, {1, 1, 4.0}});
  CHECK(solve_with_values(a, Eigen::Vector2d(0, 9), {{0, 1.0}}) == Eigen::Vector2d(1, 2));
}
