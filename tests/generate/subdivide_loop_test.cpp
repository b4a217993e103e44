#include <concino/generate/subdivide_loop.hpp>

#include <concino/generate/box.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/jitter.hpp>

#include <support/kinds.hpp>
#include <support/subdivisions.hpp>

using namespace concino;
using namespace concino::testing;

namespace {

const std::vector<vec3> tet_points{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
const trimesh tet_surface(tet_points, std::vector<std::vector<unsigned>>{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});

}  // namespace

TEST_CASE("subdivide_loop: a tetrahedron, by hand") {
  const trimesh s = subdivide_loop(tet_surface);
  check_sound(s, 2);
  // Three triangles at a vert: 7/16 of it and 3/16 of each neighbour, which sum up to its opposite.
  for (unsigned v = 0; v < 4; ++v) CHECK(norm(point(s, vert_id{v}) - 0.25 * tet_points[v]) < 1e-15);
  for (const edge_id e : edges(tet_surface)) {
    const auto [a, b] = end_verts(tet_surface, e);
    const vec3 sum = tet_points[a.raw()] + tet_points[b.raw()];  // the sum of the two others is its opposite
    CHECK(norm(point(s, vert_id{4 + e.raw()}) - 0.25 * sum) < 1e-15);
  }
}

TEST_CASE("subdivide_loop: properties, correspondence, repetition") {
  check_subdivision(icosphere(0), [](const auto& m, const subdivide_options& o) { return subdivide_loop(m, o); });
  check_subdivision(grid<trimesh>(2), [](const auto& m, const subdivide_options& o) { return subdivide_loop(m, o); });
}

TEST_CASE("subdivide_loop: a plane stays one, and its boundary is a cubic spline") {
  trimesh m = grid<trimesh>(4);
  jitter(m, 0.2);
  const trimesh s = subdivide_loop(m, {.times = 2});
  check_sound(s, 1);
  for (const vert_id v : verts(s)) CHECK(point(s, v).z == 0);
  const trimesh square(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, std::vector<std::vector<unsigned>>{{0, 1, 2}, {0, 2, 3}});
  const trimesh once = subdivide_loop(square);
  CHECK(norm(point(once, vert_id{0}) - vec3{0.125, 0.125, 0}) < 1e-16);
  for (const edge_id e : edges(square))
    if (num_elements(adj_e2p(square, e)) == 1) {
      const auto [a, b] = end_verts(square, e);
      CHECK(norm(point(once, vert_id{4 + e.raw()}) - 0.5 * (point(square, a) + point(square, b))) < 1e-16);
    }
}

TEST_CASE("subdivide_loop: creases stay, through several steps") {
  const trimesh box = make_box<trimesh>({.cells = {1, 1, 1}});
  auto crease = make_edge_map<bool>(box, false);
  for (const edge_id e : edges(box)) {
    const auto [a, b] = end_verts(box, e);
    crease[e] = norm(point(box, b) - point(box, a)) < 1.1;  // not the diagonals of its faces
  }
  const trimesh s = subdivide_loop(box, crease, {.times = 3});
  check_sound(s, 2);
  CHECK(total_measure(s) == doctest::Approx(6).epsilon(1e-13));
  CHECK(enclosed_volume(s) == doctest::Approx(1).epsilon(1e-13));
  CHECK(enclosed_volume(subdivide_loop(box, {.times = 3})) < 0.5);

  // One crease through an octahedron: its verts stay in a plane, as those of the boundary of the upper half do.
  const std::vector<vec3> points{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const trimesh whole(points, std::vector<std::vector<unsigned>>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
  const trimesh half(points, std::vector<std::vector<unsigned>>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  auto equator = make_edge_map<bool>(whole, false);
  for (const edge_id e : edges(whole)) {
    const auto [a, b] = end_verts(whole, e);
    equator[e] = point(whole, a).z == 0 && point(whole, b).z == 0;
  }
  correspondence c;
  const trimesh upper = subdivide_loop(half, {.times = 3}), both = subdivide_loop(whole, equator, {.times = 3, .correspondence = &c});
  double area_above = 0;
  for (const poly_id p : polys(both))
    if (c.polys.only(p.raw()) < 4) area_above += measure(both, p);
  CHECK(area_above == doctest::Approx(total_measure(upper)).epsilon(1e-13));
}

TEST_CASE("subdivide_loop: needs triangles") {
  CHECK_THROWS_WITH_AS(subdivide_loop(grid<polygonmesh>(1)), doctest::Contains("subdivide_loop: poly 0 has 8 verts, but must have 3"), unsupported);
}
