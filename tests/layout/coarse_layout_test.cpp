// Singularities, separatrices and blocks: known counts, refinement, storage, sums of valences, files, archetypes.
#include <concino/layout/coarse_layout.hpp>
#include <concino/layout/separatrices.hpp>
#include <concino/layout/singularities.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit/elements.hpp>
#include <concino/generate/subdivide_midpoint.hpp>
#include <concino/validate.hpp>

#include <support/layouts.hpp>
#include <support/permuted.hpp>

#include <doctest/doctest.h>

#include <array>
#include <set>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
auto summary(const std::vector<singularity<M>>& all) {
  std::multiset<std::array<std::size_t, 3>> r;
  for (const auto& s : all) r.insert({s.valence, s.on_boundary, s.is_manifold});
  return r;
}

template<class M>
std::size_t num_blocks(const M& m) { return coarse_layout(m).num_blocks; }

}  // namespace

TEST_CASE("coarse_layout: known counts do not change by refinement") {
  for (const std::size_t n : {1u, 2u, 5u}) {
    const auto cube = make_sphere<quadmesh>({.cells = n});
    const auto l = coarse_layout(cube);
    CHECK(l.num_blocks == 6);
    CHECK_FALSE(l.periodic);
    REQUIRE(l.blocks.has_value());
    CHECK(num_verts(*l.blocks) == 8);
    CHECK(num_edges(*l.blocks) == 12);
    CHECK(validate(*l.blocks).facts.closed);
    CHECK(singular_verts(cube).size() == 8);
    CHECK(separatrices(cube).size() == 12);
    for (const auto& b : l.sizes) CHECK(b == layout_block{{static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(n), 1}, {}});
  }
  for (const std::size_t n : {3u, 6u}) {
    const auto torus = make_torus<quadmesh>({.cells = {n, 4}});
    const auto l = coarse_layout(torus);
    CHECK(l.num_blocks == 1);
    CHECK(l.periodic);
    CHECK_FALSE(l.blocks.has_value());
    CHECK(l.why_no_blocks == "a block continues with its own polys, so it has no corners");
    CHECK((l.sizes[0].periodic == std::array<bool, 3>{true, true, false}));
    CHECK(l.sizes[0].size[0] * l.sizes[0].size[1] == 4 * n);
  }
  hexmesh ball = make_sphere<hexmesh>({.cells = 1});
  for (int k = 0; k < 3; ++k) {
    const auto l = coarse_layout(ball);
    CHECK(l.num_blocks == 7);
    REQUIRE(l.blocks.has_value());
    CHECK(num_verts(*l.blocks) == 16);
    CHECK(singular_edges(*l.blocks).size() == singular_edges(ball).size() >> k);
    expect_grids(ball, l);
    ball = subdivide_midpoint(ball);
  }
  const auto box = make_grid<hexmesh>({.cells = {4, 3, 2}});
  const auto grid = coarse_layout(box);
  CHECK(grid.num_blocks == 1);
  CHECK(grid.sizes[0] == layout_block{{4, 3, 2}, {}});
  CHECK(grid.blocks.has_value());
  const auto bent = concave_quads();
  const auto l = coarse_layout(bent);
  CHECK(l.num_blocks == 3);
  CHECK(separatrices(concave_quads()).size() == 2);
}

TEST_CASE_TEMPLATE("coarse_layout: blocks are grids and fit, however the mesh is stored", M, quadmesh, hexmesh) {
  for (const auto& one : meshes_with_layouts<M>()) {
    INFO(one.name);
    const M& m = one.mesh;
    const auto l = coarse_layout(m);
    expect_grids(m, l);
    const M copy = permute(m, 7).mesh;
    const auto other = coarse_layout(copy);
    expect_grids(copy, other);
    CHECK(other.num_blocks == l.num_blocks);
    CHECK(other.why_no_blocks == l.why_no_blocks);
    if (!l.periodic) CHECK(sorted_sizes(other) == sorted_sizes(l));
    CHECK(separatrices(copy).size() == separatrices(m).size());
    CHECK(summary(singular_verts(copy)) == summary(singular_verts(m)));
    if (l.blocks) {
      CHECK(validate(*l.blocks, {.kinds = {defect_kind::non_manifold_face, defect_kind::duplicated_element}}).is_clean());
      CHECK(num_blocks(*l.blocks) == l.num_blocks);  // each poly is a block of its own
    }
    if (num_polys(m) > 3000) continue;
    const M fine = subdivide_midpoint(m);
    CHECK(num_blocks(fine) == l.num_blocks);
    if constexpr (HexMesh<M>) CHECK(summary(singular_edges(copy)) == summary(singular_edges(m)));
  }
}

TEST_CASE("singular_verts: the sum of valences is that of the Euler characteristic") {
  for (const auto& one : meshes_with_layouts<quadmesh>()) {
    INFO(one.name);
    const auto& m = one.mesh;
    long sum = 0;
    for (const auto& s : singular_verts(m)) {
      REQUIRE(s.is_manifold);
      CHECK(s.on_boundary == is_boundary(m, s.element));
      CHECK(s.valence == num_elements(adj_v2p(m, s.element)));
      sum += (s.on_boundary ? 2 : 4) - static_cast<long>(s.valence);
    }
    const long chi = static_cast<long>(num_verts(m)) - static_cast<long>(num_edges(m)) + static_cast<long>(num_polys(m));
    CHECK(sum == 4 * chi);
  }
}

TEST_CASE("singular_edges and singular_verts of hexes") {
  const auto box = make_grid<hexmesh>({.cells = {3, 3, 3}});
  CHECK(singular_edges(box).size() == 36);
  CHECK(singular_verts(box).size() == 8);
  for (const auto& v : singular_verts(box)) CHECK((v.valence == 3 && v.on_boundary));
  CHECK(separatrices(box).empty());
  const auto ball = make_sphere<hexmesh>({.cells = 2});
  CHECK(summary(singular_edges(ball)).count({3, 0, 1}) > 0);
  for (const auto& e : singular_edges(ball)) {
    CHECK(e.valence == num_elements(adj_e2p(ball, e.element)));
    CHECK(e.on_boundary == is_boundary(ball, e.element));
  }
  CHECK(separatrices(ball).size() == 18);  // the six faces of the cube within, and one from each of its twelve edges
  auto open = box;
  remove_poly(open, poly_id{13});  // a hole: its edges have three hexes
  CHECK(summary(singular_edges(open)).count({3, 1, 1}) == 12);
  CHECK(num_blocks(open) == 26);
  expect_grids(open, coarse_layout(open));
}

TEST_CASE("layouts of meshes that are not manifold, of none, and of polygons that are no quads") {
  const quadmesh book({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, 1, 0}, {0, 0, 1}, {0, 1, 1}}, {{0, 2, 3, 1}, {1, 5, 4, 0}, {0, 6, 7, 1}});
  CHECK(summary(singular_verts(book)).count({3, 1, 0}) == 2);
  CHECK(num_blocks(book) == 3);
  CHECK(num_blocks(subdivide_midpoint(book)) == 3);
  // two squares at a vert
  const quadmesh bow({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}}, {{0, 1, 2, 3}, {2, 4, 5, 6}});
  CHECK(summary(singular_verts(bow)).count({2, 1, 0}) == 1);
  CHECK(coarse_layout(bow).blocks.has_value());
  // hexes at a common edge, and at a vert
  const auto two = make_grid<hexmesh>({.cells = {2, 2, 2}});
  auto edge = two;
  for (const unsigned p : {1u, 2u, 4u, 5u, 6u, 7u}) remove_poly(edge, poly_id{p});
  CHECK(num_blocks(edge) == 2);
  CHECK(summary(singular_edges(edge)).count({2, 1, 0}) == 1);
  CHECK(num_blocks(quadmesh()) == 0);
  CHECK(num_blocks(hexmesh()) == 0);
  const hexmesh nothing;
  CHECK(coarse_layout(nothing).blocks.has_value());
  CHECK(singular_verts(hexmesh()).empty());
  CHECK(separatrices(quadmesh()).empty());
  auto gaps = make_grid<quadmesh>({.cells = {3, 3, 1}});
  remove_poly(gaps, poly_id{4});
  add_vert(gaps, {9, 9, 9});
  CHECK(num_blocks(gaps) == 8);
  expect_grids(gaps, coarse_layout(gaps));
  const polygonmesh mixed({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2, 3}, {1, 4, 2}});
  CHECK_THROWS_WITH_AS(coarse_layout(mixed), "coarse_layout: poly 1 is not a quad; all polys of the mesh have to be quads", invalid_mesh);
  CHECK_THROWS_AS(singular_verts(mixed), invalid_mesh);
  CHECK_THROWS_AS(separatrices(mixed), invalid_mesh);
}

TEST_CASE("coarse_layout: blocks that touch themselves or each other on the same verts are no mesh") {
  // two squares on the same four verts: a sphere
  const quadmesh pillow({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}, {3, 2, 1, 0}});
  const auto l = coarse_layout(pillow);
  CHECK(l.num_blocks == 2);
  CHECK_FALSE(l.periodic);
  CHECK(l.why_no_blocks == "two blocks have the same verts");
  const auto subdivided = subdivide_midpoint(pillow);
  const auto fine = coarse_layout(subdivided);
  CHECK(fine.num_blocks == 2);
  CHECK(fine.why_no_blocks == "two blocks have the same verts");
  const auto path = corpus("quad/moebius.obj");
  if (path.empty()) return skip("quad/moebius.obj");
  const auto strip = load<quadmesh>(path);
  const auto one = coarse_layout(strip);
  CHECK(one.num_blocks == 1);
  CHECK(one.periodic);
  expect_grids(strip, one);
}

TEST_CASE("coarse_layout: archetypes") {
  const auto m = make_sphere<quadmesh>({.cells = 2});
  const auto h = make_sphere<hexmesh>({.cells = 2});
  const auto a = only_fixed_arity_mesh(m);
  const auto b = only_fixed_arity_mesh(h);
  CHECK(num_blocks(a) == 6);
  CHECK(num_blocks(b) == 7);
  CHECK(separatrices(a).size() == 12);
  CHECK(separatrices(b).size() == 18);
  CHECK(singular_verts(only_surface_mesh(m)).size() == 8);
  CHECK(singular_verts(b).size() == singular_verts(h).size());
}
