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

namespace {

detail::numbered_triangles numbered(const trimesh& m) {
  detail::numbered_triangles t{num_verts(m), num_edges(m), core::flat_array<detail::numbered_triangles::corner>(3 * num_polys(m))};
  for (const poly_id p : polys(m))
    for (unsigned k = 0; k < 3; ++k) t.corners[3 * p.raw() + k] = {adj_p2v(m, p)[k].raw(), adj_p2e(m, p)[k].raw()};
  return t;
}

/// The tables of the split triangles, from the verts of each.
surface_tables<3> built(const detail::numbered_triangles& t) {
  std::vector<vert_id> lists;
  for (std::size_t c = 0; c < t.corners.size(); c += 3) {
    const auto middle = [&](std::size_t k) { return vert_id{t.num_verts + t.corners[c + k].edge}; };
    for (std::size_t k = 0; k < 3; ++k) lists.insert(lists.end(), {vert_id{t.corners[c + k].vert}, middle(k), middle((k + 2) % 3)});
    lists.insert(lists.end(), {middle(0), middle(1), middle(2)});
  }
  return surface_tables<3>(t.num_verts + t.num_edges, lists);
}

}  // namespace

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

TEST_CASE("subdivide_1_to_4: tables are derived if edges have at most two triangles, else built") {
  const auto is_derived = [](const trimesh& m) { return detail::has_derived_tables(numbered(m)); };
  CHECK(is_derived(grid<trimesh>(4)));
  CHECK(is_derived(icosphere(1)));
  const std::vector<vec3> x(5);
  CHECK(is_derived(trimesh(x, std::vector<std::vector<unsigned>>{{0, 1, 2}, {0, 1, 3}})));  // not oriented alike
  CHECK_FALSE(is_derived(trimesh(x, std::vector<std::vector<unsigned>>{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})));
  CHECK_FALSE(is_derived(trimesh(x, std::vector<std::vector<unsigned>>{{0, 1, 2}, {2, 1, 0}})));

  // Any numbers, also those of no mesh, or of one with two edges between the same verts.
  std::mt19937 random(11);
  std::size_t derived = 0;
  for (int i = 0; i < (long_run() ? 100000 : 3000); ++i) {
    detail::numbered_triangles t{4, 6, core::flat_array<detail::numbered_triangles::corner>(3 * (1 + random() % 3))};
    bool is_valid = true;
    for (std::size_t c = 0; c < t.corners.size(); ++c) t.corners[c] = {static_cast<unsigned>(random() % 4), static_cast<unsigned>(random() % 6)};
    if (i % 2 == 0)  // with the same ends for each edge
      for (std::size_t c = 0; c < t.corners.size(); ++c) t.corners[c].vert = (static_cast<unsigned>(c % 3) + (i % 4 == 0 && c > 2 ? t.corners[3].vert : 0)) % 3;
    for (std::size_t c = 0; c < t.corners.size(); c += 3)
      for (std::size_t k = 0; k < 3; ++k) is_valid &= t.corners[c + k].edge != t.corners[c + (k + 1) % 3].edge;
    if (!is_valid) continue;
    const std::vector<vec3> points(10);
    derived += detail::has_derived_tables(t);
    has_same_adjacency(trimesh(points, detail::triangles_in_four(t)), trimesh(points, built(t)));
  }
  CHECK(derived > 100);
}
