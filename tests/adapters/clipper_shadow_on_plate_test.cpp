#include <concino/adapters/clipper.hpp>
#include <concino/concepts/archetypes.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/io/load.hpp>
#include <concino/print/region_offset.hpp>
#include <concino/print/shadow_on_plate.hpp>

#include <support/corpus.hpp>
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
using namespace concino::testing;

namespace {

constexpr double pi = 3.14159265358979324;

/// The area of a regular polygon of n corners in a circle.
double area_in_circle(double n, double radius) { return 0.5 * n * radius * radius * std::sin(2 * pi / n); }

/// Whether a point of the plane is in the regions.
bool holds(const planar_regions& r, double x, double y) {
  int crossings = 0;
  for (std::size_t i = 0; i < r.num_contours(); ++i) {
    const auto c = r.contour(i);
    for (std::size_t k = 0; k < c.size(); ++k) {
      const slice_point &a = c[k], &b = c[(k + 1) % c.size()];
      if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) ++crossings;
    }
  }
  return crossings % 2 == 1;
}

}  // namespace

TEST_CASE_TEMPLATE("shadow_on_plate: a box and a table, in any position", M, CONCINO_ALL_KINDS) {
  std::set<voxel> box;
  add_voxels(box, {1, 2, 3}, {3, 5, 7});
  const M m = voxel_part<M>(box);
  const plate_shadow s = shadow_on_plate(m, clipper);
  REQUIRE(s.size() == 1);
  CHECK(s.num_holes(0) == 0);
  CHECK(s.area() == 6);
  CHECK(s.step_x == vec3{1, 0, 0});
  CHECK(s.step_y == vec3{0, 1, 0});
  CHECK(s.origin == vec3{0, 0, 3});
  for (const slice_point& p : s.points) CHECK(((p[0] >= 1 && p[0] <= 3) && (p[1] >= 2 && p[1] <= 5)));
  CHECK(shadow_on_plate(m, clipper, {.plate = -2}).origin == vec3{0, 0, -2});
  CHECK(shadow_on_plate(m, clipper, {.direction = {0, -7, 0}}).area() == 8);
  // a convex part covers half the sum of what its sides cover
  for (const vec3& d : {vec3{1, 2, 3}, vec3{-4, 0.5, 1}, vec3{1, 1, 0}}) {
    const double expected = (12 * std::abs(d.x) + 8 * std::abs(d.y) + 6 * std::abs(d.z)) / norm(d);
    const plate_shadow tilted = shadow_on_plate(m, clipper, {.direction = d});
    CHECK(tilted.size() == 1);
    CHECK(tilted.area() == doctest::Approx(expected).epsilon(1e-11));
    CHECK(dot(tilted.origin, d) / norm(d) == doctest::Approx(dot(vec3{d.x > 0 ? 1.0 : 3.0, d.y > 0 ? 2.0 : 5.0, 3}, d) / norm(d)));
  }
  const M turned = voxel_part<M>(table(), [](const vec3& x) { return rotated(x) + vec3{100, -20, 3}; });
  CHECK(shadow_on_plate(turned, clipper, {.direction = rotated({0, 0, 1})}).area() == doctest::Approx(20).epsilon(1e-11));
  CHECK(shadow_on_plate(only_embedded_mesh(m), clipper, {.direction = {1, 2, 3}}).points == shadow_on_plate(m, clipper, {.direction = {1, 2, 3}}).points);
}

TEST_CASE_TEMPLATE("shadow_on_plate: random solids cover what their columns cover", M, trimesh, quadmesh, tetmesh) {
  std::mt19937 random(3);
  for (int round = 0; round < 8; ++round) {
    std::set<voxel> v;
    std::set<std::pair<int, int>> columns, rows;
    for (int i = 0; i < 20; ++i) {
      const voxel x{static_cast<int>(random() % 7), static_cast<int>(random() % 7), static_cast<int>(random() % 3)};
      v.insert(x);
      columns.insert({x[0], x[1]});
      rows.insert({x[1], x[2]});
    }
    const M m = voxel_part<M>(v);
    CHECK(shadow_on_plate(m, clipper).area() == static_cast<double>(columns.size()));
    CHECK(shadow_on_plate(m, clipper, {.direction = {1, 0, 0}}).area() == static_cast<double>(rows.size()));
    const M turned = voxel_part<M>(v, [](const vec3& x) { return rotated(x); });
    CHECK(shadow_on_plate(turned, clipper, {.direction = -rotated({0, 0, 1})}).area() == doctest::Approx(static_cast<double>(columns.size())).epsilon(1e-10));
  }
}

TEST_CASE("shadow_on_plate: a sphere covers a disk, a torus a ring, or a strip with round ends") {
  for (const std::size_t cells : {8u, 32u}) {
    const auto ball = make_sphere<trimesh>({.cells = cells});
    for (const vec3& d : {vec3{0, 0, 1}, vec3{3, -2, 1}}) {
      const plate_shadow s = shadow_on_plate(ball, clipper, {.direction = d});
      CHECK(s.size() == 1);
      CHECK(s.area() <= pi);
      CHECK(s.area() == doctest::Approx(pi).epsilon(2.0 / static_cast<double>(cells * cells)));
    }
  }
  const double n = 48, k = 24, radius = 2, tube = 0.5;
  const auto ring = make_torus<quadmesh>({.cells = {48, 24}, .radius = radius, .tube_radius = tube});
  const plate_shadow above = shadow_on_plate(ring, clipper);
  REQUIRE(above.size() == 1);
  CHECK(above.num_holes(0) == 1);
  CHECK(above.area() == doctest::Approx(area_in_circle(n, radius + tube) - area_in_circle(n, radius - tube)).epsilon(1e-11));
  const plate_shadow beside = shadow_on_plate(ring, clipper, {.direction = {1, 0, 0}});
  REQUIRE(beside.size() == 1);
  CHECK(beside.num_holes(0) == 0);
  CHECK(beside.area() == doctest::Approx(2 * radius * 2 * tube + area_in_circle(k, tube)).epsilon(1e-11));
  // a rounder look: the hole is open up to the angle at which its near side hides the far one
  CHECK(shadow_on_plate(ring, clipper, {.direction = {1, 0, 1}}).num_holes(0) == 1);
  CHECK(shadow_on_plate(ring, clipper, {.direction = {4, 0, 1}}).num_holes(0) == 0);
  const double brim = region_offset(above, 0.1, clipper, {.corners = offset_corners::mitred, .mitre_limit = 4}).area();
  CHECK(brim > above.area() + 0.1 * 2 * pi * 2 * radius * 0.99);
}

TEST_CASE("shadow_on_plate: parts beside one another, within one another, open and inside out, and of any size") {
  const trimesh two({{0, 0, 0}, {1, 0, 1}, {0, 1, 0}, {3, 0, 2}, {4, 0, 2}, {4, 1, 2}, {0.1, 0.1, 5}, {0.1, 0.2, 5}, {0.2, 0.1, 5}}, {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
  const plate_shadow s = shadow_on_plate(two, clipper);
  CHECK(s.size() == 2);
  CHECK(s.area() == doctest::Approx(1).epsilon(1e-11));
  CHECK(shadow_on_plate(two, clipper, {.direction = {0, 0, -1}}).area() == doctest::Approx(1).epsilon(1e-11));
  for (const double factor : {0x1p-200, 0x1p200}) {
    const auto scaled = shadow_on_plate(voxel_part<quadmesh>(table(), [&](const vec3& x) { return factor * x; }), clipper);
    CHECK(scaled.area() == 20 * factor * factor);
  }
  CHECK(shadow_on_plate(voxel_part<quadmesh>(table(), [](const vec3& x) { return x + vec3{0x1p30, -0x1p30, 0}; }), clipper).area() == 20);
}

TEST_CASE("shadow_on_plate: a bunny covers a point if a line through it meets the bunny") {
  CONCINO_CORPUS_OR_SKIP(path, "tri/bunny.obj");
  const trimesh m = load<trimesh>(path);
  const vec3 d = rotated({0, 0, 1});
  const plate_shadow s = shadow_on_plate(m, clipper, {.direction = d});
  CHECK(norm(cross(s.step_x, s.step_y) - d) < 1e-14);
  std::mt19937_64 random(9);
  double left = 1e300, right = -1e300, bottom = 1e300, top = -1e300;
  for (const slice_point& p : s.points) {
    left = std::min(left, p[0]), right = std::max(right, p[0]);
    bottom = std::min(bottom, p[1]), top = std::max(top, p[1]);
  }
  std::uniform_real_distribution<double> across(left, right), up(bottom, top);
  const auto in_plane = [&](vert_id v) { return vec3{dot(point(m, v) - s.origin, s.step_x), dot(point(m, v) - s.origin, s.step_y), 0}; };
  int differ = 0;
  for (int i = 0; i < 60; ++i) {
    const vec3 x{across(random), up(random), 0};
    bool is_covered = false;
    for (const poly_id p : polys(m)) {
      std::vector<vec3> c;
      for (const vert_id v : adj_p2v(m, p)) c.push_back(in_plane(v) - x);
      const double a = c[0].x * c[1].y - c[0].y * c[1].x, b = c[1].x * c[2].y - c[1].y * c[2].x, e = c[2].x * c[0].y - c[2].y * c[0].x;
      is_covered = is_covered || (a > 0 && b > 0 && e > 0) || (a < 0 && b < 0 && e < 0);
    }
    differ += is_covered != holds(s, x.x, x.y);
  }
  CHECK(differ == 0);
}

TEST_CASE("shadow_on_plate: bad input, and what has no shadow") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(shadow_on_plate(trimesh{}, clipper).empty());
  const trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  CHECK(shadow_on_plate(m, clipper).area() == 0.5);
  CHECK(shadow_on_plate(m, clipper, {.direction = {1, 0, 0}}).empty());
  CHECK_THROWS_AS(shadow_on_plate(m, clipper, {.direction = {0, 0, 0}}), invalid_argument);
  CHECK_THROWS_AS(shadow_on_plate(m, clipper, {.direction = {0, nan, 1}}), invalid_argument);
  CHECK_THROWS_WITH_AS(shadow_on_plate(m, clipper, {.plate = 1}), "shadow_on_plate: options.plate is above the lowest point of the part", invalid_argument);
  CHECK_THROWS_WITH_AS(shadow_on_plate(trimesh{}, clipper, {.plate = nan}), "shadow_on_plate: options.plate is not finite", invalid_argument);
  CHECK_THROWS_WITH_AS(shadow_on_plate(trimesh({{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}, {{0, 1, 2}}), clipper), "shadow_on_plate: vert 2 is not finite", invalid_mesh);
  CHECK_THROWS_AS(shadow_on_plate(trimesh({{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}}, {{0, 1, 2}}), clipper), unsupported);
}
