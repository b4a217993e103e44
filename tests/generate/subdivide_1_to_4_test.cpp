#include <concino/generate/subdivide_1_to_4.hpp>

#include <concino/edit/elements.hpp>
#include <concino/generate/icosphere.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/random_meshes.hpp>
#include <support/rebuilt.hpp>
#include <support/subdivisions.hpp>

using namespace concino;
using namespace concino::testing;

TEST_CASE("subdivide_1_to_4: halves all edges and numbers the elements in order") {
  const trimesh m = grid<trimesh>(3);
  const trimesh s = subdivide_1_to_4(m);
  check_sound(s, 1);
  REQUIRE(num_verts(s) == num_verts(m) + num_edges(m));
  REQUIRE(num_polys(s) == 4 * num_polys(m));
  for (const vert_id v : verts(m)) CHECK(point(s, v) == point(m, v));
  for (const edge_id e : edges(m)) {
    const auto [a, b] = end_verts(m, e);
    CHECK(norm(point(s, vert_id{num_verts(m) + e.raw()}) - 0.5 * (point(m, a) + point(m, b))) < 1e-16);
  }
  for (const poly_id p : polys(m))
    for (const unsigned k : {0u, 1u, 2u, 3u}) CHECK(measure(s, poly_id{4 * p.raw() + k}) == doctest::Approx(measure(m, p) / 4).epsilon(1e-13));
}

TEST_CASE("subdivide_1_to_4: properties, correspondence, repetition") {
  check_subdivision(grid<trimesh>(2), [](const auto& m, const subdivide_options& o) { return subdivide_1_to_4(m, o); });
}

TEST_CASE("subdivide_1_to_4: a closed surface keeps its area and its shape") {
  const trimesh m = icosphere(1), s = subdivide_1_to_4(m, {.times = 3});
  check_sound(s, 2);
  CHECK(num_polys(s) == 64 * num_polys(m));
  CHECK(total_measure(s) == doctest::Approx(total_measure(m)).epsilon(1e-13));
}

TEST_CASE("subdivide_1_to_4: any mesh of triangles, but no other polygons") {
  const polygonmesh triangles(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 5, 5}}, std::vector<std::vector<unsigned>>{{0, 1, 2}, {0, 1, 3}, {0, 1, 2}});
  const trimesh s = subdivide_1_to_4(triangles);  // three triangles at an edge, two of them the same
  CHECK(num_polys(s) == 12);
  CHECK(num_verts(s) == num_verts(triangles) + num_edges(triangles));
  CHECK(check_laws(s).empty());
  CHECK_THROWS_WITH_AS(subdivide_1_to_4(grid<quadmesh>(2)), "subdivide_1_to_4: poly 0 has 4 verts, but must have 3; to_triangles() cuts all polygons into triangles", unsupported);

  trimesh bad(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}, std::vector<std::vector<unsigned>>{{0, 1, 2}});
  CHECK(num_polys(subdivide_1_to_4(bad)) == 4);
}

TEST_CASE("subdivide_1_to_4: all adjacency is that of a mesh constructed from the verts of the triangles") {
  const auto check = [](const auto& m, unsigned times = 1) {
    const trimesh s = subdivide_1_to_4(m, {.times = times});
    has_same_adjacency(s, rebuilt(s).first);
  };
  check(trimesh());
  check(grid<trimesh>(4));
  check(grid<trimesh>(2), 3);
  check(icosphere(1), 2);
  check(trimesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 7, 7}}, {{0, 1, 2}, {2, 1, 0}}));             // two triangles with three common edges, and a vert without any
  check(trimesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 1, 3}, {2, 0, 3}}));  // edges wound both ways
  trimesh with_gaps = grid<trimesh>(3);
  for (const unsigned p : {0u, 7u, 8u}) remove_poly(with_gaps, poly_id{p});
  check(with_gaps);
  std::mt19937 random(7);
  for (int i = 0; i < (long_run() ? 2000 : 100); ++i) check(random_mesh<trimesh>(random));
}

TEST_CASE("subdivide_1_to_4: the result can be edited") {
  trimesh s = subdivide_1_to_4(grid<trimesh>(2));
  for (const unsigned p : {3u, 4u, 11u}) remove_poly(s, poly_id{p});
  const vert_id v = add_vert(s, vec3{9, 9, 9});
  const auto e = *edges(s).begin();
  const auto [a, b] = end_verts(s, e);
  add_poly(s, {a, b, v});
  CHECK(check_laws(s).empty());
  equals_rebuilt(s);
}
