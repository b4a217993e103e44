#include <concino/render/drawable.hpp>
#include <concino/render/shapes.hpp>

#include <concino/mesh/element_map.hpp>

#include <doctest/doctest.h>
#include <support/kinds.hpp>

#include <limits>
#include <set>

using namespace concino;

namespace {

double area_of(const drawable& d) {
  double sum = 0;
  for (const auto& t : d.triangles) {
    const vec3 a = d.points[d.corners[t[0]]], b = d.points[d.corners[t[1]]], c = d.points[d.corners[t[2]]];
    sum += norm(cross(b - a, c - a)) / 2;
  }
  return sum;
}

}  // namespace

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
  const drawable d = make_drawable(m, u);
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

TEST_CASE("make_balls: balls are round, closed and at their centres") {
  const vec3 centers[] = {{0, 0, 0}, {5, 0, 0}};
  const drawable d = make_balls(centers, 2, srgb(1, 0, 0));
  CHECK(area_of(d) == doctest::Approx(2 * 4 * 3.14159265 * 4).epsilon(0.01));
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const auto& t : d.triangles)
    for (std::size_t k = 0; k < 3; ++k) CHECK(sides.emplace(d.corners[t[k]], d.corners[t[(k + 1) % 3]]).second);
  for (const auto& [a, b] : sides) REQUIRE(sides.count({b, a}) == 1);
  CHECK_THROWS_AS(make_balls(centers, 0, {}), invalid_argument);
  const vec3 bad{0, std::numeric_limits<double>::quiet_NaN(), 0};
  CHECK_THROWS_AS(make_balls({&bad, 1}, 1, {}), invalid_argument);
}
