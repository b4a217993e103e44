#include <concino/level_sets/detail/simple_surface.hpp>

#include <concino/mesh/polygonmesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

namespace cn = concino;

namespace {

using lists = std::vector<std::vector<unsigned>>;

bool has_one_fan(const lists& polys) {
  std::vector<cn::vec3> points(10);
  for (unsigned i = 0; i < 10; ++i) points[i] = {1.0 * i, 1.0 * i * i, 0};
  const cn::polygonmesh m(points, polys);
  return cn::detail::fan_checker<cn::polygonmesh>(m).has_one_fan(cn::vert_id{0});
}

}  // namespace

TEST_CASE("simple_surface: a vert with one fan of polys, in any order of these") {
  lists closed{{1, 0, 2}, {2, 0, 3}, {3, 0, 4}, {4, 0, 1}}, open{{1, 0, 2}, {2, 0, 3}, {3, 0, 4}};
  lists two_open{{1, 0, 2}, {2, 0, 3}, {4, 0, 5}}, two_closed{{1, 0, 2}, {2, 0, 3}, {3, 0, 1}, {4, 0, 5}, {5, 0, 6}, {6, 0, 4}};
  lists closed_and_one{{1, 0, 2}, {2, 0, 3}, {3, 0, 1}, {1, 0, 4}};  // three polys at one edge
  lists with_flap{{1, 0, 2}, {2, 0, 3}, {3, 0, 1}, {1, 0, 4}, {5, 0, 1}};
  for (lists* const x : {&closed, &open, &two_open, &two_closed, &closed_and_one, &with_flap}) std::sort(x->begin(), x->end());
  do CHECK(has_one_fan(closed)); while (std::next_permutation(closed.begin(), closed.end()));
  do CHECK(has_one_fan(open)); while (std::next_permutation(open.begin(), open.end()));
  do CHECK_FALSE(has_one_fan(two_open)); while (std::next_permutation(two_open.begin(), two_open.end()));
  do CHECK_FALSE(has_one_fan(two_closed)); while (std::next_permutation(two_closed.begin(), two_closed.end()));
  do CHECK_FALSE(has_one_fan(closed_and_one)); while (std::next_permutation(closed_and_one.begin(), closed_and_one.end()));
  do CHECK_FALSE(has_one_fan(with_flap)); while (std::next_permutation(with_flap.begin(), with_flap.end()));
}

TEST_CASE("simple_surface: a long closed fan") {
  lists fan;
  for (unsigned i = 1; i < 10; ++i) fan.push_back({i, 0, i % 9 + 1});
  CHECK(has_one_fan(fan));
  fan.erase(fan.begin() + 3);
  CHECK(has_one_fan(fan));
  fan.erase(fan.begin() + 6);
  CHECK_FALSE(has_one_fan(fan));
}
