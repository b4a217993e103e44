#include <concino/render/make_drawable.hpp>

#include <concino/mesh/element_map.hpp>

#include <doctest/doctest.h>
#include <support/drawables.hpp>
#include <support/kinds.hpp>

#include <limits>

using namespace concino;

using testing::area_of;

TEST_CASE_TEMPLATE("drawable: contains the boundary of a grid, oriented outward", M, CONCINO_ALL_KINDS) {
  const M m = testing::grid<M>(3);
  const drawable d = make_drawable(m);
  const bool volume = dimension_v<M> == 3;
  CHECK(area_of(d) == doctest::Approx(volume ? 6.0 : 1.0));
  REQUIRE(d.offsets.back() == d.corners.size());
  REQUIRE(d.normals.size() == d.corners.size());
  REQUIRE(d.polys.size() == d.polygons().size());
  CHECK(d.values.empty());
  std::size_t expected = 0;
  for (std::size_t p = 0; p < d.polys.size(); ++p) {
    CHECK(d.polys[p] < poly_index_bound(m));
    expected += d.offsets[p + 1] - d.offsets[p] - 2;
  }
  CHECK(d.triangles.size() == expected);
  for (std::size_t c = 0; c < d.corners.size(); ++c) {
    const vec3 n = to_vec3(d.normals[c]), p = d.points[d.corners[c]];
    CHECK(norm(n) == doctest::Approx(1));
    if (volume) CHECK(dot(n, p - vec3{0.5, 0.5, 0.5}) == doctest::Approx(0.5));  // a cube: its faces are planar, and its edges sharp
    else CHECK(n.z == doctest::Approx(1));
  }
  if (!volume) CHECK(d.polygons().size() == num_polys(m));
}

TEST_CASE_TEMPLATE("drawable: takes values from the map, and the scale spans the finite ones", M, CONCINO_ALL_KINDS) {
  const M m = testing::grid<M>(2);
  auto u = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) u[v] = 10 + point(m, v)[0];
  u[*verts(m).begin()] = std::numeric_limits<double>::infinity();
  const drawable d = make_drawable(m, {.field = u});
  REQUIRE(d.values.size() == d.points.size());
  for (std::size_t i = 0; i < d.points.size(); ++i)
    if (std::isfinite(d.values[i])) CHECK(d.values[i] == 10 + d.points[i].x);
  CHECK(d.look.scale.low() == 10);
  CHECK(d.look.scale.high() == 11);
}

TEST_CASE("drawable: is empty for an empty mesh; invalid input throws") {
  CHECK(make_drawable(trimesh{}).triangles.empty());
  CHECK(make_drawable(tetmesh{}).triangles.empty());
  CHECK_THROWS_AS(make_drawable(trimesh{}, {.crease_angle = 181}), invalid_argument);
  CHECK_THROWS_AS(make_drawable(trimesh{}, {.crease_angle = std::numeric_limits<double>::quiet_NaN()}), invalid_argument);
}
