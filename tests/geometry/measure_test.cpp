#include <concino/geometry/measure.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("measure: of grids of the unit square or cube is 1, at any position and scale", M, CONCINO_ALL_KINDS) {
  const auto arrays = grid_arrays<M>(3);
  const M m(arrays);
  CHECK(total_measure(m) == doctest::Approx(1).epsilon(1e-14));
  CHECK(total_measure(M(rotated(arrays))) == doctest::Approx(1).epsilon(1e-12));
  for (const double scale : {0x1p-40, 0x1p30}) {
    const M s(scaled(arrays, scale));
    for (const auto p : polys(m)) {
      CHECK(measure(m, p) > 0);
      CHECK(measure(s, p) == measure(m, p) * (SurfaceMesh<M> ? scale * scale : scale * scale * scale));
    }
  }
}

TEST_CASE_TEMPLATE("measure: cells with warped faces fill the cube, wherever interior points are", M, CONCINO_VOLUME_KINDS) {
  auto arrays = grid_arrays<M>(4);
  const auto wild = jittered(arrays, 0.1);
  for (std::size_t i = 0; i < arrays.points.size(); ++i) {
    vec3& x = arrays.points[i];
    if (std::min({x.x, x.y, x.z}) > 0 && std::max({x.x, x.y, x.z}) < 1) x = wild.points[i];
  }
  CHECK(total_measure(M(arrays)) == doctest::Approx(1).epsilon(1e-13));
}

TEST_CASE_TEMPLATE("measure: is the same to the bit on the archetype", M, CONCINO_ALL_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.1));
  const auto g = only_embedded_mesh(m);
  for (const auto p : polys(m)) CHECK(measure(g, g.poly(p)) == doctest::Approx(measure(m, p)).epsilon(1e-14));
  CHECK(total_measure(g) == doctest::Approx(total_measure(m)).epsilon(1e-14));
  if constexpr (VolumeMesh<M>)
    for (const auto f : faces(m)) CHECK(area(g, g.face(f)) == area(m, f));
}

TEST_CASE("area: is right for concave, folded and degenerate polygons") {
  const polygonmesh m({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4, 5}, {5, 4, 3, 2, 1, 0}, {0, 1, 2, 5}});
  CHECK(area(m, poly_id{0}) == 3);
  CHECK(area_vector(m, poly_id{0}) == vec3{0, 0, 3});
  CHECK(area_vector(m, poly_id{1}) == vec3{0, 0, -3});
  const trimesh flat({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, {{0, 1, 2}});
  CHECK(area(flat, poly_id{0}) == 0);
  const trimesh spot({{2, 1, 5}, {2, 1, 5}, {2, 1, 5}}, {{0, 1, 2}});
  CHECK(area(spot, poly_id{0}) == 0);
  const quadmesh saddle({{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}}, {{0, 1, 2, 3}});
  CHECK(area_vector(saddle, poly_id{0}) == vec3{0, 0, 1});
}

TEST_CASE("volume: is right for inverted cells, frustums and degenerate cells") {
  const tetmesh t({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}, {0, 2, 1, 3}});
  CHECK(volume(t, poly_id{0}) == doctest::Approx(1.0 / 6));
  CHECK(volume(t, poly_id{1}) == doctest::Approx(-1.0 / 6));
  double skin = 0;
  for (const auto f : faces(t)) skin += area(t, f);
  CHECK(skin == doctest::Approx(1.5 + std::sqrt(3.0) / 2));

  // a frustum with a 2 x 2 bottom, a 1 x 1 top and height 3: h/3 (A + B + sqrt(A B))
  const hexmesh frustum({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0.5, 0.5, 3}, {1.5, 0.5, 3}, {1.5, 1.5, 3}, {0.5, 1.5, 3}}, {{0, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(volume(frustum, poly_id{0}) == doctest::Approx(7).epsilon(1e-14));
  const hexmesh pressed({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(volume(pressed, poly_id{0}) == 0);
}

TEST_CASE("volume: of an inverted polyhedron is negative, the areas of its faces are not") {
  auto arrays = polyhedra_grid(1);
  const polyhedralmesh m(arrays);
  for (auto& out : arrays.outward) out = !out;
  const polyhedralmesh inside_out(arrays);
  CHECK(total_measure(m) == doctest::Approx(1));
  CHECK(total_measure(inside_out) == -total_measure(m));
  double surface = 0;
  for (const auto f : faces(m)) surface += area(m, f);
  CHECK(surface == doctest::Approx(6 + 1));  // the cube and the two faces between the L and the rest of the cube
}

TEST_CASE_TEMPLATE("measures: returns the measure of each poly", M, CONCINO_ALL_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.1));
  const auto size = measures(m);
  for (const auto p : polys(m)) CHECK(size[p] == measure(m, p));
  const auto g = only_embedded_mesh(m);
  const auto stripped = measures(g);
  for (const auto p : polys(m)) CHECK(stripped[g.poly(p)] == measure(g, g.poly(p)));
}

TEST_CASE_TEMPLATE("measure: of an empty mesh is 0", M, CONCINO_ALL_KINDS) {
  CHECK(total_measure(M()) == 0);
}

TEST_CASE_TEMPLATE("measure: of finite points is never NaN, and infinite if too large", M, CONCINO_ALL_KINDS) {
  for (const double scale : {1e150, 1e200, 1e300, 1e308}) {
    auto arrays = scaled(grid_arrays<M>(3), scale);
    for (const bool centred : {false, true}) {
      if (centred)
        for (vec3& x : arrays.points) x = 1.7 * (x - vec3{scale / 2, scale / 2, SurfaceMesh<M> ? 0 : scale / 2});
      const M m(arrays);
      const bool fits = SurfaceMesh<M> && scale < 1e151;
      const double total = total_measure(m);
      CHECK((fits ? std::isfinite(total) : total == HUGE_VAL));
      const auto all = measures(m);
      for (const auto p : polys(m)) {
        CHECK(all[p] == measure(m, p));
        CHECK((fits ? all[p] > 0 : all[p] == HUGE_VAL));
      }
    }
    for (vec3& x : arrays.points) x.x = -x.x;  // mirrored
    CHECK_FALSE(std::isnan(total_measure(M(arrays))));
  }
}
