#include <concino/solve/checked_solver.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/systems.hpp>

using namespace concino;
using namespace systems;

TEST_CASE("checked_solver: refuses what is wrong, and analyses a pattern once") {
  checked_solver checks("mine");
  sparse storage;
  const auto twice = [](const Eigen::VectorXd& b) { return Eigen::VectorXd(2 * b); };
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(4);
  CHECK_THROWS_WITH_AS(checks.solve(one, twice), "mine: solve without a factorised matrix; call factorize first", solver_error);
  CHECK_THROWS_WITH_AS(checks.begin_square(sparse(2, 3), storage), doctest::Contains("mine: the matrix has 2 rows"), solver_error);
  int analysed = 0;
  const auto analyse = [&](const sparse&) { ++analysed; };
  for (const double scale : {1.0, 2.0}) {
    const sparse a = scale * grid(2);
    checks.analyse_once(checks.begin_square(a, storage), analyse);
    CHECK_THROWS_AS(checks.solve(one, twice), solver_error);
    checks.accept(4);
    CHECK(checks.solve(one, twice) == 2 * one);
  }
  CHECK(analysed == 1);
  CHECK_THROWS_WITH_AS(checks.solve(Eigen::VectorXd::Ones(3), twice), doctest::Contains("3 entries, the matrix 4 rows"), solver_error);
  CHECK_THROWS_AS(checks.solve(one * std::nan(""), twice), solver_error);
  CHECK_THROWS_AS(checks.solve(one, [](const Eigen::VectorXd& b) { return Eigen::VectorXd(b / 0.0); }), solver_error);
  checked_solver other("other");
  other.use_pattern_of(checks);
  const sparse a = grid(2);
  other.analyse_once(other.begin(a, storage), analyse);
  CHECK(analysed == 1);
  other.forget_pattern();
  other.analyse_once(other.begin(a, storage), analyse);
  CHECK(analysed == 2);
  sparse loose(4, 4);
  loose.insert(2, 2) = 1;
  REQUIRE_FALSE(loose.isCompressed());
  CHECK(&checks.begin(loose, storage) == &storage);
  CHECK(storage.isCompressed());
}
