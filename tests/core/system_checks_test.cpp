#include <concino/core/system_checks.hpp>

#include <support/systems.hpp>

#include <limits>
#include <string>

using namespace concino;
using namespace systems;

TEST_CASE("system_checks: the error names the entry that is not finite") {
  for (int i = 0; i < 4; ++i)
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
      Eigen::VectorXd b = Eigen::VectorXd::Ones(4);
      CHECK_NOTHROW(core::check_right_hand_side("x", b, 4));
      CHECK_NOTHROW(core::check_solution("x", b));
      b[i] = bad;
      const std::string name = "x: entry " + std::to_string(i) + " of the ";
      CHECK_THROWS_WITH_AS(core::check_right_hand_side("x", b, 4), (name + "right-hand side is not finite").c_str(), solver_error);
      CHECK_THROWS_WITH_AS(core::check_solution("x", b), doctest::Contains((name + "solution is not finite").c_str()), solver_error);
    }
}

TEST_CASE("system_checks: returns the diagonal, also without stored entries") {
  const sparse a = from(4, 4, {{0, 0, 2.0}, {1, 0, 7.0}, {0, 1, 7.0}, {1, 1, -3.0}, {2, 1, 5.0}, {1, 2, 5.0}, {3, 2, 11.0}, {3, 3, 4.0}});
  CHECK(core::diagonal(a) == std::vector<double>{2, -3, 0, 4});
}

TEST_CASE("system_checks: compares patterns by sizes and positions of entries") {
  const sparse a = from(3, 2, {{0, 0, 1.0}, {1, 0, 2.0}}), other_values = from(3, 2, {{0, 0, 5.0}, {1, 0, 0.0}});
  const sparse higher = from(4, 2, {{0, 0, 1.0}, {1, 0, 2.0}}), wider = from(3, 3, {{0, 0, 1.0}, {1, 0, 2.0}});
  const sparse other_column = from(3, 2, {{0, 0, 1.0}, {1, 1, 2.0}}), other_row = from(3, 2, {{0, 0, 1.0}, {2, 0, 2.0}});
  core::sparsity_pattern pattern;
  for (const sparse& m : {sparse(0, 0), sparse(1, 1), a}) CHECK(!pattern.is_of(m));
  pattern.remember(a);
  CHECK(pattern.is_of(a));
  CHECK(pattern.is_of(other_values));
  for (const sparse& m : {higher, wider, other_column, other_row}) CHECK(!pattern.is_of(m));
  for (const sparse& m : {sparse(0, 0), sparse(1, 1), a}) {
    pattern.remember(m);
    CHECK(pattern.is_of(m));
    pattern.invalidate();
    CHECK(!pattern.is_of(m));
  }
  int analysed = 0;
  for (const sparse& m : {a, other_values, higher, higher}) pattern.update(m, [&](const sparse&) { ++analysed; });
  CHECK(analysed == 2);
}

TEST_CASE("system_checks: finds the power of two that scales to [1, 2), or 1") {
  CHECK(core::power_of_two_to_scale(1) == 1);
  CHECK(core::power_of_two_to_scale(3) == 0.5);
  CHECK(core::power_of_two_to_scale(0.1) == 16);
  for (const double none : {0.0, -3.0, 0x1p-1000, 0x1p1000, HUGE_VAL, std::nan("")}) CHECK(core::power_of_two_to_scale(none) == 1);
}
