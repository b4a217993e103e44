#include <concino/print/height_map.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/printed_parts.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

using namespace concino;
using testing::voxel_part;

TEST_CASE_TEMPLATE("height_map: heights of a solid of voxels", M, CONCINO_KINDS) {
  std::mt19937 random(4);
  std::set<testing::voxel> v;
  testing::add_voxels(v, {0, 0, 0}, {6, 4, 1});
  for (int i = 0; i < 50; ++i) v.insert({static_cast<int>(random() % 6), static_cast<int>(random() % 4), static_cast<int>(random() % 5)});
  const auto height_at = [&](int i, int j) {
    int h = 0;
    for (int k = 0; k < 5; ++k)
      if (v.count({i, j, k})) h = k + 1;
    return h;
  };
  const auto check = [&](const height_map_result& h, int cells) {
    REQUIRE(h.columns == static_cast<std::size_t>(6 * cells));
    REQUIRE(h.rows == static_cast<std::size_t>(4 * cells));
    bool same = true;
    for (std::size_t j = 0; j < h.rows; ++j)
      for (std::size_t i = 0; i < h.columns; ++i) same = same && h(i, j) == doctest::Approx(height_at(static_cast<int>(i) / cells, static_cast<int>(j) / cells));
    CHECK(same);
  };
  const M m = voxel_part<M>(v);
  check(height_map(m, {.resolution = 6}), 1);
  check(height_map(m, {.resolution = 30}), 5);
  check(height_map(only_embedded_mesh(m), {.resolution = 12}), 2);
  const auto h = height_map(m, {.resolution = 6, .plate = -2});
  CHECK(h(0, 0) == height_at(0, 0) + 2);
  CHECK(h.origin == vec3{0.5, 0.5, -2});
  CHECK(h.step_x == vec3{1, 0, 0});
  CHECK(h.step_y == vec3{0, 1, 0});
  // from below all cells see the plate of voxels, which is 1 thick or more
  const auto below = height_map(m, {.direction = {0, 0, -3}, .resolution = 24});
  for (const double x : below.heights) CHECK(x == doctest::Approx(below(0, 0)));
}

TEST_CASE("height_map: turned parts, sheets, and cells without anything above") {
  // two triangles of a roof over [0, 1]^2, with a gap between them
  const trimesh roof({{0, 0, 0}, {1, 0, 1}, {0, 1, 0}, {3, 0, 2}, {4, 0, 2}, {4, 1, 2}}, {{0, 1, 2}, {3, 4, 5}});
  const auto h = height_map(roof, {.resolution = 40});
  CHECK(h.columns == 40);
  CHECK(h.rows == 10);
  for (std::size_t j = 0; j < h.rows; ++j)
    for (std::size_t i = 0; i < h.columns; ++i) {
      const double x = (double(i) + 0.5) / 10, y = (double(j) + 0.5) / 10;
      if (std::abs(x + y - 1) < 1e-9 || std::abs(x - 3 - y) < 1e-9) continue;  // on a border
      CHECK(h(i, j) == doctest::Approx(x + y < 1 ? x : x - 3 > y ? 2 : 0));
    }
  // the sum of heights times the area of cells is the volume below, in any position
  const auto moved = voxel_part<trimesh>(testing::letter_t(), [](const vec3& x) { return testing::rotated(x) + vec3{100, 2, 3}; });
  const auto t = height_map(moved, {.direction = testing::rotated(vec3{0, 0, 1}), .resolution = 400});
  double volume = 0;
  for (const double x : t.heights) volume += x * norm(t.step_x) * norm(t.step_y);
  CHECK(volume == doctest::Approx(6 * 2 * 5).epsilon(0.01));
  CHECK(dot(t.step_x, t.step_y) == doctest::Approx(0));
}

TEST_CASE("height_map: bad input") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(height_map(trimesh{}).heights.empty());
  const trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const auto edge_on = height_map(m, {.direction = {1, 0, 0}, .resolution = 8});
  CHECK(edge_on.columns * edge_on.rows == 8);
  for (const double x : edge_on.heights) CHECK(x == 0);
  CHECK_THROWS_AS(height_map(m, {.direction = {0, 0, 0}}), invalid_argument);
  CHECK_THROWS_AS(height_map(m, {.resolution = 0}), invalid_argument);
  CHECK_THROWS_AS(height_map(m, {.resolution = 20000}), invalid_argument);
  CHECK_THROWS_AS(height_map(m, {.plate = nan}), invalid_argument);
  CHECK_THROWS_AS(height_map(m, {.plate = 1}), invalid_argument);
  CHECK_THROWS_WITH_AS(height_map(trimesh({{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}, {{0, 1, 2}})), "height_map: vert 2 is not finite", invalid_mesh);
}
