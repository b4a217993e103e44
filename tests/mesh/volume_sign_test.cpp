#include <concino/mesh/volume_sign.hpp>

#include <concino/mesh/standard_cells.hpp>

#include <support/unit_cells.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr cell_shape standard_shapes[] = {cell_shape::tet, cell_shape::hex, cell_shape::prism, cell_shape::pyramid};

/// The verts of a cell and its mirror image: whether the volume of each is negative.
std::pair<bool, bool> are_negative(cell_shape s, const std::vector<vec3>& points) {
  const standard_cell& t = standard_cell_of(s);
  vert_id v[8], mirrored[8];
  for (unsigned i = 0; i < t.num_verts; ++i) v[i] = vert_id{i}, mirrored[i] = vert_id{t.mirrored[i]};
  return {has_negative_volume(s, v, points), has_negative_volume(s, mirrored, points)};
}

}  // namespace

TEST_CASE("volume_sign: cells of all magnitudes have the sign of the unit cell, and flat cells none") {
  for (const cell_shape s : standard_shapes)
    for (const double x : {1e-300, 1e-80, 1.0, 1e80, 1e300})
      for (const double y : {1e-250, 1.0, 1e250})
        for (const double z : {1e-200, 1.0, 1e305}) {
          std::vector<vec3> points = unit_cell(s);
          for (vec3& p : points) p = {p.x * x, p.y * y, p.z * z};
          CHECK(are_negative(s, points) == std::pair(false, true));
          for (vec3& p : points) p.z = 0.1 * z;
          CHECK(are_negative(s, points) == std::pair(false, false));
        }
}

TEST_CASE("volume_sign: a cell and its mirror image are never both negative") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> real(-1, 1);
  std::size_t num_decided = 0;
  for (const cell_shape s : standard_shapes)
    for (int i = 0; i < 5000; ++i) {
      std::vector<vec3> points(standard_cell_of(s).num_verts);
      const int spread = i % 60;  // almost flat, at a place far away
      for (vec3& p : points) p = {real(random), real(random), 0.3 * p.x + std::ldexp(real(random), -spread) + 7};
      for (vec3& p : points) p.z += p.x / 3 - p.y / 7;
      const auto [one, other] = are_negative(s, points);
      CHECK_FALSE((one && other));
      num_decided += one || other;
      if (spread < 30) CHECK((one || other));
    }
  CHECK(num_decided < 19000);  // of the flattest ones, no double can tell
}
