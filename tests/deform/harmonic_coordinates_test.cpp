#include <concino/deform/harmonic_coordinates.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views/with_points.hpp>
#include <concino/generate/voxel_hexes.hpp>

#include <support/closed_surfaces.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("harmonic_coordinates: reproduce linear functions, and are not negative", M, CONCINO_ALL_VOLUME_KINDS) {
  const M m(grid_arrays<M>(4));
  const quadmesh cage(voxel_skin({{0, 0, 0}}));
  const auto w = harmonic_coordinates(m, cage);
  const auto raw = harmonic_coordinates(m, cage, {.non_negative = false});
  auto bent = cage;
  for (const auto v : verts(bent)) set_point(bent, v, 2 * rotated(point(cage, v)) + vec3{1, 2, 3});
  const auto x = w.points_of(bent), y = raw.points_of(bent);
  CHECK(w.num_negative == 0);
  for (const auto v : verts(m)) {
    const vec3 there = 2 * rotated(to_vec3(point(m, v))) + vec3{1, 2, 3};
    CHECK(distance(y[v], there) < 1e-11);
    CHECK(distance(x[v], there) < 1e-11);
    double sum = 0;
    for (const double a : w.of(v)) {
      CHECK(a >= 0);
      sum += a;
    }
    CHECK(std::abs(sum - 1) < 1e-14);
  }
  const auto g = only_embedded_mesh(m);
  const auto z = harmonic_coordinates(g, only_embedded_mesh(cage));
  for (const auto v : verts(g)) CHECK(z.weights().of(index_of(g, v))[0] == doctest::Approx(w.weights().of(index_of(g, v))[0]).epsilon(1e-9));
}

TEST_CASE("harmonic_coordinates: do not move what is near outside, but far inside") {
  // A U of voxels: the tips of its arms are close, and the weights of the verts of one are small at the other.
  const quadmesh cage(voxel_skin({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}}));
  const hexmesh m = voxel_hexes(cage, 12);
  const auto w = harmonic_coordinates(m, cage);
  CHECK(w.num_negative == 0);
  double other = 0;
  for (const auto v : verts(m))
    if (point(m, v).x <= 1 && point(m, v).y > 2.5)
      for (const auto c : verts(cage))
        if (point(cage, c).x >= 2) other = std::max(other, w.of(v)[c.raw()]);
  CHECK(other < 1e-3);
}

TEST_CASE("harmonic_coordinates: bad input") {
  const quadmesh cage(voxel_skin({{0, 0, 0}}));
  const hexmesh m(hex_grid(2));
  CHECK_THROWS_WITH_AS((void)harmonic_coordinates(m, quadmesh(voxel_skin({{0, 0, 0}, {1, 0, 0}}))), doctest::Contains("is on the boundary of the volume, but not on the cage"), invalid_argument);
  CHECK_THROWS_AS((void)harmonic_coordinates(m, quadmesh(quad_grid(2))), invalid_mesh);
  CHECK_THROWS_AS((void)harmonic_coordinates(m, quadmesh()), invalid_mesh);
  CHECK_THROWS_AS((void)harmonic_coordinates(m, cage, {.tolerance = -1}), invalid_argument);
  CHECK_THROWS_AS((void)harmonic_coordinates(m, cage, {.tolerance = std::numeric_limits<double>::quiet_NaN()}), invalid_argument);
  CHECK_THROWS_AS((void)harmonic_coordinates(m, cage, {.progress = [](double, std::string_view) { return false; }}), cancelled);
  auto bad = m;
  set_point(bad, vert_id{0}, vec3{std::numeric_limits<double>::infinity(), 0, 0});
  CHECK_THROWS_AS((void)harmonic_coordinates(bad, cage), invalid_mesh);
  const hexmesh empty;
  CHECK(harmonic_coordinates(empty, cage).weights().num_points() == 0);
}
