#include <concino/level_sets/detail/lines/cancelling_steps.hpp>

#include <doctest/doctest.h>

using namespace concino::detail;

TEST_CASE("find_cancelling_steps: pairs steps in opposite directions, and each step once") {
  // Curve 0: 1 2 3 2; curve 1: 3 2 1; curve 2: 1 2.
  const auto found = find_cancelling_steps({{1, 2, 0, 0}, {2, 3, 0, 1}, {3, 2, 0, 2}, {3, 2, 1, 0}, {2, 1, 1, 1}, {1, 2, 2, 0}});
  REQUIRE(found.size() == 4);
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK(found[i].other != i);
    CHECK(found[found[i].other].other == i);
    if (i > 0) CHECK((found[i - 1].curve < found[i].curve || (found[i - 1].curve == found[i].curve && found[i - 1].step < found[i].step)));
  }
  CHECK(find_cancelling_steps({}).empty());
  CHECK(find_cancelling_steps({{1, 2, 0, 0}, {1, 2, 1, 0}, {1, 3, 2, 0}}).empty());
}
