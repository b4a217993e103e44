#include <concino/render/ambient_occlusion.hpp>

#include <doctest/doctest.h>
#include <support/brute_force.hpp>
#include <support/kinds.hpp>

using namespace concino;
using testing::brute_force;

namespace {

// A square well of the given depth, open at the top. Its polygons are oriented to the inside of the well; the floor is poly 0.
polygonmesh well(double depth) {
  return polygonmesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, depth}, {1, 0, depth}, {1, 1, depth}, {0, 1, depth}},
                     {{0, 1, 2, 3}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}});
}

}  // namespace

TEST_CASE_TEMPLATE("ambient_occlusion: a plane and a convex body have no occlusion", M, CONCINO_KINDS) {
  const M m = testing::grid<M>(2);
  const auto ao = ambient_occlusion(m, {.directions = 32}, brute_force{});
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
}

TEST_CASE("ambient_occlusion: a deep well is darker than a shallow one, and distance limits occlusion") {
  const polygonmesh deep = well(4), shallow = well(0.1);
  const poly_id floor{0};
  const auto dark = ambient_occlusion(deep, {.directions = 256}, brute_force{});
  CHECK(dark[floor] < 0.1);
  CHECK(ambient_occlusion(shallow, {.directions = 256}, brute_force{})[floor] > 0.8);
  CHECK(ambient_occlusion(deep, {.distance = 0.01}, brute_force{})[floor] == 1);
  for (unsigned side = 1; side < 5; ++side) CHECK(dark[poly_id{side}] < 0.6);
}

TEST_CASE("ambient_occlusion: the sky visible through a square opening is its form factor") {
  // The form factor from the centre of a unit square to a parallel one at distance 1 is 4/pi (a/sqrt(1+a^2)) atan(a/sqrt(1+a^2)) with a = 1/2.
  // The centroids of the two triangles of the floor are not at the centre, where the factor is larger.
  const polygonmesh m = well(1);
  const double b = 0.5 / std::sqrt(1.25), middle = 4 / 3.14159265358979 * b * std::atan(b);
  const double ao = ambient_occlusion(m, {.directions = 4000}, brute_force{})[poly_id{0}];
  CHECK(ao < middle);
  CHECK(ao > 0.85 * middle);
}

TEST_CASE("ambient_occlusion: throws on options out of range, and on cancelling") {
  const trimesh m = testing::grid<trimesh>(1);
  CHECK_THROWS_AS(ambient_occlusion(m, {.directions = 0}, brute_force{}), invalid_argument);
  CHECK_THROWS_AS(ambient_occlusion(m, {.distance = 0}, brute_force{}), invalid_argument);
  const auto stop = [](double, const char*) { return false; };
  CHECK_THROWS_AS(ambient_occlusion(m, {.progress = stop}, brute_force{}), cancelled);
}
