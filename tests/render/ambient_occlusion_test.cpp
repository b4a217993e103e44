#include <concino/render/ambient_occlusion.hpp>

#include <doctest/doctest.h>
#include <support/brute_force.hpp>
#include <support/kinds.hpp>
#include <support/threads.hpp>
#include <support/user_mesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace concino;
using testing::brute_force;

namespace {

// A square well of the given depth, open at the top. Its polygons are oriented to the inside of the well; the floor is poly 0.
polygonmesh well(double depth) {
  return polygonmesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, depth}, {1, 0, depth}, {1, 1, depth}, {0, 1, depth}},
                     {{0, 1, 2, 3}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}});
}

/// A square with bumps and hollows, of n x n pairs of triangles.
trimesh bumps(std::uint32_t n) {
  std::vector<vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      const double x = 20.0 * i / n, y = 20.0 * j / n;
      points.push_back({x, y, std::sin(2 * x) * std::sin(2 * y)});
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
      triangles.insert(triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
    }
  return trimesh(points, triangles);
}

}  // namespace

TEST_CASE_TEMPLATE("ambient_occlusion: a plane and a convex body have no occlusion", M, CONCINO_KINDS) {
  const M m = testing::grid<M>(2);
  const auto ao = ambient_occlusion(m, {.rays = 32}, brute_force{});
  for (const auto p : polys(m)) {
    bool visible = dimension_v<M> == 2;
    if constexpr (VolumeMesh<M>)
      for (const auto f : adj_p2f(m, p)) {
        std::size_t sides = 0;
        for ([[maybe_unused]] const auto q : adj_f2p(m, f)) ++sides;
        visible = visible || sides == 1;
      }
    CHECK(ao[p] == (visible ? 1 : 0));
  }
  const auto at_verts = ambient_occlusion_at_verts(m, {.rays = 32}, brute_force{});
  for (const auto v : verts(m)) CHECK(at_verts[v] == (is_boundary(m, v) || dimension_v<M> == 2 ? 1 : 0));
}

TEST_CASE("ambient_occlusion: a deep well is darker than a shallow one, and distance limits occlusion") {
  const polygonmesh deep = well(4), shallow = well(0.1);
  const poly_id floor{0};
  const auto dark = ambient_occlusion(deep, {.rays = 256}, brute_force{});
  CHECK(dark[floor] < 0.1);
  CHECK(ambient_occlusion(shallow, {.rays = 256}, brute_force{})[floor] > 0.8);
  CHECK(ambient_occlusion(deep, {.distance = 0.01}, brute_force{})[floor] == 1);
  for (unsigned side = 1; side < 5; ++side) CHECK(dark[poly_id{side}] < 0.6);
  const auto at_verts = ambient_occlusion_at_verts(deep, {.rays = 600}, brute_force{});
  for (unsigned v = 0; v < 4; ++v) {
    CHECK(at_verts[vert_id{v}] < 0.1);
    CHECK(at_verts[vert_id{v + 4}] > 0.15);  // at the opening, in a corner: less than a quarter of the sky
    CHECK(at_verts[vert_id{v + 4}] < 0.3);
  }
}

TEST_CASE("ambient_occlusion: the built-in ray tracer gives the same as brute force, and the same for every number of threads") {
  const polygonmesh m = well(1);
  CHECK(ambient_occlusion(m).values()[0] == doctest::Approx(ambient_occlusion(m, {}, brute_force{}).values()[0]));
  const trimesh fine = bumps(40);
  const auto bytes = [&](int threads) {
    const testing::with_num_threads now(threads);
    const auto at_polys = ambient_occlusion(fine, {.rays = 16});
    const auto at_verts = ambient_occlusion_at_verts(fine, {.rays = 16});
    std::vector<double> all(at_polys.values().begin(), at_polys.values().end());
    all.insert(all.end(), at_verts.values().begin(), at_verts.values().end());
    return all;
  };
  const auto serial = bytes(1);
  CHECK(*std::min_element(serial.begin(), serial.end()) < 0.9);
  CHECK(bytes(2) == serial);
  CHECK(bytes(7) == serial);
}

TEST_CASE("ambient_occlusion: takes meshes of other types, and verts that no polygon shows") {
  user_mesh::surface own;
  own.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 5, 5}};
  own.polygons = {{0, 1, 2, 3}};
  CHECK(ambient_occlusion(own).values()[0] == 1);
  const auto at_verts = ambient_occlusion_at_verts(own, {.rays = 1});
  for (std::size_t v = 0; v < 5; ++v) CHECK(at_verts.values()[v] == (v < 4 ? 1 : 0));
  const trimesh none;
  CHECK(ambient_occlusion(none).values().empty());
  CHECK(ambient_occlusion_at_verts(none).values().empty());
  const trimesh sliver({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  CHECK(ambient_occlusion(sliver).values()[0] == 0);
  const trimesh broken({{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(ambient_occlusion_at_verts(broken), invalid_mesh);
}

TEST_CASE("ambient_occlusion: the sky visible through a square opening is its form factor") {
  // The form factor from the centre of a unit square to a parallel one at distance 1 is 4/pi (a/sqrt(1+a^2)) atan(a/sqrt(1+a^2)) with a = 1/2.
  // The centroids of the two triangles of the floor are not at the centre, where the factor is larger.
  const polygonmesh m = well(1);
  const double b = 0.5 / std::sqrt(1.25), middle = 4 / 3.14159265358979 * b * std::atan(b);
  const double ao = ambient_occlusion(m, {.rays = 4000}, brute_force{})[poly_id{0}];
  CHECK(ao < middle);
  CHECK(ao > 0.85 * middle);
}

TEST_CASE("ambient_occlusion: throws on options out of range, and on cancelling") {
  const trimesh m = testing::grid<trimesh>(1);
  CHECK_THROWS_AS(ambient_occlusion(m, {.rays = 0}, brute_force{}), invalid_argument);
  CHECK_THROWS_AS(ambient_occlusion(m, {.distance = 0}, brute_force{}), invalid_argument);
  CHECK_THROWS_AS(ambient_occlusion_at_verts(m, {.rays = -1}, brute_force{}), invalid_argument);
  const auto stop = [](double, const char*) { return false; };
  CHECK_THROWS_AS(ambient_occlusion(m, {.progress = stop}, brute_force{}), cancelled);
}
