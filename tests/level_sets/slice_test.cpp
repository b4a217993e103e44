#include <concino/level_sets/slice.hpp>

#include <concino/core/error.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/geometry/normals.hpp>

#include <support/kinds.hpp>
#include <support/level_sets.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The signed area of a slice, seen from above the plane.
template<class S>
double signed_area(const S& s, const vec3& normal) {
  double sum = 0;
  for (const auto p : polys(s.mesh)) sum += dot(area_vector(s.mesh, p), normal) / norm(normal);
  return sum;
}

}  // namespace

TEST_CASE_TEMPLATE("slice: the area of a slice of a box", M, CONCINO_VOLUME_KINDS) {
  const M m = make_grid<M>({.cells = {3, 4, 5}, .max = {1, 2, 3}});
  for (const double z : {0.1, 1.0, 1.234, 2.9}) {
    const auto s = slice(m, plane{{0, 0, 7}, 7 * z});
    CHECK(signed_area(s, {0, 0, 7}) == doctest::Approx(2).epsilon(1e-12));
    for (const auto v : verts(s.mesh)) CHECK(std::abs(point(s.mesh, v).z - z) <= 1e-12);
    check_level_surface(m, s);
  }
  const vec3 oblique{2, 1, 0};  // cuts off a corner: x + y / 2 = 0.4
  CHECK(signed_area(slice(m, plane{oblique, 0.8}), oblique) == doctest::Approx(3 * std::hypot(0.4, 0.8)).epsilon(1e-12));
  for (const double z : {-1.0, 0.0, 3.0, 4.0}) CHECK(num_polys(slice(m, plane{{0, 0, 1}, z}).mesh) == 0);  // outside, or touched
}

TEST_CASE("slice: Voronoi cells and cells that are not convex fill the slice of their box") {
  const box whole{{0, 0, 0}, {1, 1, 1}};
  const auto voronoi = voronoi_polyhedra(random_points(60, whole, 5), whole);
  auto hexes = make_grid<hexmesh>({.cells = {5, 5, 5}});
  const auto merged = agglomerate(hexes, random_labels(hexes, 6, 7));
  for (const double z : {0.05, 0.5, 0.77}) {
    CHECK(signed_area(slice(voronoi, plane{{0, 0, 1}, z}), {0, 0, 1}) == doctest::Approx(1).epsilon(1e-12));
    CHECK(signed_area(slice(merged, plane{{0, 0, 1}, z}), {0, 0, 1}) == doctest::Approx(1).epsilon(1e-12));
    const auto triangles = slice<trimesh>(merged, plane{{0, 0, 1}, z});
    CHECK(signed_area(triangles, {0, 0, 1}) == doctest::Approx(1).epsilon(1e-12));
  }
}

TEST_CASE_TEMPLATE("slice: of a surface, lines in the plane", M, CONCINO_SURFACE_KINDS) {
  const M m = make_grid<M>({.cells = {4, 6, 1}});
  const vec3 normal{1, 0.25, 0};
  const auto lines = slice(m, plane{normal, 0.5});
  REQUIRE(lines.size() == 1);
  CHECK(length_of(lines[0]) == doctest::Approx(std::hypot(1, 0.25)).epsilon(1e-12));
  for (const vec3& x : lines[0].points) CHECK(std::abs(dot(normal, x) - 0.5) <= 1e-12);
}

TEST_CASE("slice: of a sphere of triangles, a circle") {
  const auto lines = slice(icosphere(4), plane{{0.3, 0.2, 0.8}, 0});
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].closed);
  CHECK(length_of(lines[0]) == doctest::Approx(2 * 3.14159265358979324).epsilon(1e-3));
}

TEST_CASE("slice: a plane without a normal, or with coordinates that are not finite, is an error") {
  const auto m = make_grid<hexmesh>({.cells = {2, 2, 2}});
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS((void)slice(m, plane{{0, 0, 0}, 0}), invalid_argument);
  CHECK_THROWS_AS((void)slice(m, plane{{infinite, 0, 0}, 0}), invalid_argument);
  CHECK_THROWS_AS((void)slice(m, plane{{1, 0, 0}, std::nan("")}), invalid_argument);
  CHECK_THROWS_AS((void)slice(icosphere(1), plane{{0, 0, 0}, 0}), invalid_argument);
}
