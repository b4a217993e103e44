#include <concino/generate/subdivide_root3.hpp>

#include <concino/generate/box.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/geometry/centroid.hpp>

#include <support/kinds.hpp>
#include <support/subdivisions.hpp>

using namespace concino;
using namespace concino::testing;

TEST_CASE("subdivide_root3: three times as many triangles, between centres") {
  const trimesh m = icosphere(0), s = subdivide_root3(m);
  check_sound(s, 2);
  REQUIRE(num_polys(s) == 3 * num_polys(m));
  REQUIRE(num_verts(s) == num_verts(m) + num_polys(m));
  const double moved = (4 - 2 * std::cos(2 * std::numbers::pi / 5)) / 9;
  for (const vert_id v : verts(m)) CHECK(norm(point(s, v) - (1 - moved + moved / std::sqrt(5.0)) * point(m, v)) < 1e-15);
  for (const poly_id p : polys(m)) CHECK(norm(point(s, vert_id{num_verts(m) + p.raw()}) - vert_mean(m, p)) < 1e-15);
}

TEST_CASE("subdivide_root3: properties, correspondence, repetition") {
  check_subdivision(icosphere(0), [](const auto& m, const subdivide_options& o) { return subdivide_root3(m, o); }, false);
  check_subdivision(grid<trimesh>(2), [](const auto& m, const subdivide_options& o) { return subdivide_root3(m, o); }, false);
}

TEST_CASE("subdivide_root3: two steps divide each edge into three") {
  const trimesh m = grid<trimesh>(3), s = subdivide_root3(m, {.times = 2});
  check_sound(s, 1);
  CHECK(num_polys(s) == 9 * num_polys(m));
  std::size_t before = 0, after = 0;
  for (const edge_id e : edges(m)) before += num_elements(adj_e2p(m, e)) == 1;
  for (const edge_id e : edges(s)) after += num_elements(adj_e2p(s, e)) == 1;
  CHECK(after == 3 * before);
  for (const unsigned times : {1u, 3u, 4u}) check_sound(subdivide_root3(m, {.times = times}), 1);
}

TEST_CASE("subdivide_root3: creases stay, through several steps") {
  const trimesh box = make_box<trimesh>({.cells = {1, 1, 1}});
  auto crease = make_edge_map<bool>(box, false);
  for (const edge_id e : edges(box)) {
    const auto [a, b] = end_verts(box, e);
    crease[e] = norm(point(box, b) - point(box, a)) < 1.1;  // not the diagonals of its faces
  }
  for (const unsigned times : {1u, 2u, 3u, 4u}) {
    const trimesh s = subdivide_root3(box, crease, {.times = times});
    check_sound(s, 2);
    CHECK(total_measure(s) == doctest::Approx(6).epsilon(1e-13));
    CHECK(enclosed_volume(s) == doctest::Approx(1).epsilon(1e-13));
  }
}

TEST_CASE("subdivide_root3: edges with three polys, and other polygons") {
  const trimesh fin(std::vector<vec3>{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, std::vector<std::vector<unsigned>>{{0, 2, 1}, {0, 1, 3}, {0, 4, 1}});
  const trimesh s = subdivide_root3(fin, {.times = 2});
  CHECK(check_laws(s).empty());
  CHECK(num_polys(s) == 27);
  CHECK_THROWS_WITH_AS(subdivide_root3(grid<quadmesh>(1)), doctest::Contains("subdivide_root3: poly 0 has 4 verts, but must have 3"), unsupported);
}
