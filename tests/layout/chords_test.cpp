// Chords and sheets: known ones, those of all meshes together, archetypes, bad input.
#include <concino/layout/chords.hpp>
#include <concino/layout/sheets.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit/elements.hpp>

#include <support/layouts.hpp>
#include <support/permuted.hpp>

#include <doctest/doctest.h>

#include <map>
#include <set>
#include <utility>

using namespace concino;
using namespace concino::testing;

namespace {

/// Lengths in facets and polys, ends and crossings of all chords, sorted.
template<class M>
auto summary(const M& m) {
  std::multiset<std::array<std::size_t, 5>> all;
  for (const auto& c : chords(m)) all.insert({c.facets.size(), c.polys.size(), c.is_closed, c.crosses_itself, c.branches});
  return all;
}
template<class M>
auto sheet_summary(const M& m) {
  std::multiset<std::array<std::size_t, 5>> all;
  for (const auto& s : sheets(m)) all.insert({s.edges.size(), s.polys.size(), s.is_closed, s.crosses_itself, s.touches_itself});
  return all;
}

/// Each facet is in one chord; polys lie between facets; each poly is in as many as it has axes.
template<class M>
void expect_chords(const M& m) {
  auto uses = make_facet_map<int>(m, 0);
  auto crossings = make_poly_map<std::size_t>(m, 0);
  for (const auto& c : chords(m)) {
    for (const auto& f : c.facets) ++uses[f];
    std::set<std::size_t> different;
    for (const auto& p : c.polys) ++crossings[p], different.insert(index_of(m, p));
    CHECK(c.crosses_itself == (different.size() < c.polys.size()));
    if (c.branches) continue;
    REQUIRE(c.facets.size() == c.polys.size() + !c.is_closed);
    for (std::size_t i = 0; i < c.polys.size(); ++i) {
      const auto a = c.facets[i], b = c.facets[(i + 1) % c.facets.size()];
      int found = 0;
      for (const auto f : adj_p2facet(m, c.polys[i])) found += f == a || f == b;
      CHECK(found == 2);
      for (const auto v : adj_facet2v(m, a))
        for (const auto w : adj_facet2v(m, b)) CHECK(!(v == w));
    }
    if (!c.is_closed)
      for (const auto& f : {c.facets.front(), c.facets.back()}) CHECK((is_boundary(m, f) || c.polys.empty()));
    const auto same = chord_of(m, c.facets.back());
    CHECK(same.facets.size() == c.facets.size());
    CHECK(same.is_closed == c.is_closed);
  }
  for (const auto f : facets(m)) CHECK(uses[f] == 1);
  for (const auto p : polys(m)) CHECK(crossings[p] == dimension_v<M>);
}

template<class M>
void expect_sheets(const M& m) {
  auto uses = make_edge_map<int>(m, 0);
  auto crossings = make_poly_map<int>(m, 0);
  for (const auto& s : sheets(m)) {
    REQUIRE(s.polys.size() == s.crossings.size());
    bool crosses = false;
    for (std::size_t i = 0; i < s.polys.size(); ++i) crossings[s.polys[i]] += s.crossings[i], crosses = crosses || s.crossings[i] > 1;
    CHECK(crosses == s.crosses_itself);
    CHECK((s.touches_itself || !s.crosses_itself));
    for (const auto& e : s.edges) ++uses[e];
  }
  for (const auto e : edges(m)) CHECK(uses[e] == 1);
  for (const auto p : polys(m)) CHECK(crossings[p] == 3);
}

}  // namespace

TEST_CASE("chords: grids have one for each row") {
  const auto m = make_grid<quadmesh>({.cells = {4, 3, 1}});
  CHECK(summary(m) == std::multiset<std::array<std::size_t, 5>>{{5, 4, 0, 0, 0}, {5, 4, 0, 0, 0}, {5, 4, 0, 0, 0}, {4, 3, 0, 0, 0},
                                                                {4, 3, 0, 0, 0}, {4, 3, 0, 0, 0}, {4, 3, 0, 0, 0}});
  const auto h = make_grid<hexmesh>({.cells = {4, 3, 2}});
  CHECK(chords(h).size() == 4 * 3 + 4 * 2 + 3 * 2);
  CHECK(sheet_summary(h) == std::multiset<std::array<std::size_t, 5>>{{12, 6, 0, 0, 0}, {12, 6, 0, 0, 0}, {12, 6, 0, 0, 0}, {12, 6, 0, 0, 0}, {15, 8, 0, 0, 0},
                                                                      {15, 8, 0, 0, 0}, {15, 8, 0, 0, 0}, {20, 12, 0, 0, 0}, {20, 12, 0, 0, 0}});
  const auto torus = make_torus<quadmesh>({.cells = {8, 5}});
  for (const auto& c : chords(torus)) CHECK((c.is_closed && !c.crosses_itself && c.facets.size() == c.polys.size()));
  CHECK(chords(torus).size() == 13);
  const auto sphere = make_sphere<quadmesh>({.cells = 3});
  CHECK(chords(sphere).size() == 9);
  for (const auto& c : chords(sphere)) CHECK((c.is_closed && c.polys.size() == 12));
  // the shell of hexes around the cube of a ball is closed
  const auto ball = make_sphere<hexmesh>({.cells = 2});
  std::size_t closed = 0;
  for (const auto& s : sheets(ball)) closed += s.polys.size() == 24;
  CHECK(closed >= 1);
}

TEST_CASE_TEMPLATE("chords and sheets: laws on all meshes", M, quadmesh, hexmesh) {
  for (const auto& one : meshes_with_layouts<M>(long_run())) {
    INFO(one.name);
    const M& m = one.mesh;
    expect_chords(m);
    const auto copy = permute(m, 3).mesh;
    CHECK(summary(copy) == summary(m));
    if constexpr (HexMesh<M>) {
      expect_sheets(m);
      CHECK(sheet_summary(copy) == sheet_summary(m));
    }
  }
}

TEST_CASE("chords: closed ones, and ones that cross themselves") {
  const auto m = subdivide_midpoint(trimesh(projective_plane()));
  expect_chords(m);
  const auto path = corpus("quad/moebius.obj");
  if (path.empty()) return skip("quad/moebius.obj");
  std::size_t closed = 0;
  const auto strip = load<quadmesh>(path);
  for (const auto& c : chords(strip)) closed += c.is_closed;
  CHECK(closed > 0);
  // a quad whose chord comes back through its other pair of edges: around a vert with three quads
  const quadmesh three({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 1}});
  CHECK(chords(three).size() == 3);
}

TEST_CASE("chords: facets with three polys, facets without polys, removed polys") {
  // three quads at one edge: the chord through it has three ends
  const quadmesh book({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, 1, 0}, {0, 0, 1}, {0, 1, 1}}, {{0, 2, 3, 1}, {1, 5, 4, 0}, {0, 6, 7, 1}});
  expect_chords(book);
  std::size_t branching = 0;
  for (const auto& c : chords(book)) {
    branching += c.branches;
    if (c.branches) CHECK((c.facets.size() == 4 && c.polys.size() == 3 && !c.is_closed));
  }
  CHECK(branching == 1);
  CHECK(summary(permute(book, 5).mesh) == summary(book));
  auto m = make_grid<quadmesh>({.cells = {3, 3, 1}});
  remove_poly(m, poly_id{4});
  expect_chords(m);
  CHECK(chords(m).size() == 8);
  auto h = make_grid<hexmesh>({.cells = {3, 3, 3}});
  remove_poly(h, poly_id{13});
  expect_chords(h);
  expect_sheets(h);
  CHECK(chords(quadmesh()).empty());
  CHECK(sheets(hexmesh()).empty());
}

TEST_CASE("chords and sheets: what is not an element, or not a quad") {
  auto m = make_grid<quadmesh>({.cells = {2, 2, 1}});
  CHECK_THROWS_WITH_AS(chord_of(m, edge_id{99}), "chord_of: edge 99 is not an edge of the mesh", invalid_mesh);
  auto h = make_grid<hexmesh>({.cells = {2, 2, 1}});
  CHECK_THROWS_WITH_AS(chord_of(h, face_id{99}), "chord_of: face 99 is not a face of the mesh", invalid_mesh);
  CHECK_THROWS_WITH_AS(sheet_of(h, edge_id{99}), "sheet_of: edge 99 is not an edge of the mesh", invalid_mesh);
  const polygonmesh mixed({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2, 3}, {1, 4, 2}});
  CHECK_THROWS_WITH_AS(chords(mixed), "chords: poly 1 is not a quad; all polys of the mesh have to be quads", invalid_mesh);
  const polygonmesh five({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}}, {{0, 1, 2, 3, 4}});
  CHECK_THROWS_AS(chord_of(five, edge_id{0}), invalid_mesh);
}

TEST_CASE("chords and sheets: archetypes") {
  const auto m = make_sphere<quadmesh>({.cells = 2});
  const auto a = only_fixed_arity_mesh(m);
  CHECK(summary(a) == summary(m));
  CHECK(summary(only_surface_mesh(m)) == summary(m));
  const auto h = make_sphere<hexmesh>({.cells = 2});
  const auto b = only_fixed_arity_mesh(h);
  CHECK(summary(b) == summary(h));
  CHECK(sheet_summary(b) == sheet_summary(h));
}
