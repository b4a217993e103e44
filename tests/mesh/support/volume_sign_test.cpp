#include <concino/mesh/support/volume_sign.hpp>

#include <concino/io/detail/cells/orient.hpp>
#include <concino/mesh/support/standard_cells.hpp>

#include <support/unit_cells.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
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

TEST_CASE("volume_sign: cells of coordinates of all magnitudes have one sign, whether they are given by verts or by faces") {
  std::mt19937 random(8);
  const auto number = [&](int exponent) -> double {  // or 0, or about 1
    const double x = (random() % 2 ? 1 : -1) * (1 + 0.001 * static_cast<double>(random() % 1000));
    const auto kind = random() % 6;
    return kind < 2 ? 0 : kind == 2 ? x : std::ldexp(x, exponent);
  };
  const int exponents[] = {-1050, -1000, -300, -30, 0, 40, 300, 850, 1000};
  for (const cell_shape s : standard_shapes)
    for (int i = 0; i < 5000; ++i) {
      const standard_cell& t = standard_cell_of(s);
      std::vector<vec3> points(t.num_verts);
      const int x = exponents[random() % 9], y = exponents[random() % 9], z = exponents[random() % 9];
      for (vec3& p : points) p = {number(x), number(y), number(z)};
      const auto [one, other] = are_negative(s, points);
      CHECK_FALSE((one && other));
      std::vector<vert_id> face_verts;
      std::vector<std::uint32_t> offsets{0};
      for (unsigned f = 0; f < t.num_faces; ++f) {
        for (unsigned k = 0; k < t.face_size[f]; ++k) face_verts.push_back(vert_id{t.face_vert[f][k]});
        offsets.push_back(static_cast<std::uint32_t>(face_verts.size()));
      }
      std::vector<std::uint8_t> outward(t.num_faces, 1), inward(t.num_faces, 0);
      const auto is_negative = [&](std::vector<std::uint8_t>& flags) {  // as readers find out
        const concino::detail::oriented_faces p{offsets.data(), face_verts.data(), flags.data(), t.num_faces};
        return concino::detail::has_negative_volume(p, points);
      };
      const bool by_faces = is_negative(outward), mirrored = is_negative(inward);
      CHECK(by_faces == one);
      CHECK(mirrored == other);
    }
}
