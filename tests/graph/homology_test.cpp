#include <concino/graph/homology.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/graph/boundary_loops.hpp>
#include <concino/graph/cut_along.hpp>
#include <concino/mesh/boundary.hpp>

#include <support/closed_surfaces.hpp>
#include <support/corpus_meshes.hpp>
#include <support/disk.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <set>

using namespace concino;
using namespace concino::testing;

namespace {

/// Every edge joins its verts, and the last leads back to the first.
template<class M>
void check_closed(const M& m, const edge_walk<M>& loop) {
  REQUIRE(loop.is_closed());
  for (std::size_t i = 0; i < loop.edges.size(); ++i) {
    const auto& a = loop.verts[i];
    const auto& b = loop.verts[(i + 1) % loop.verts.size()];
    bool has_a = false, has_b = false;
    for (const auto v : adj_e2v(m, loop.edges[i])) {
      has_a = has_a || v == a;
      has_b = has_b || v == b;
    }
    REQUIRE(has_a);
    REQUIRE(has_b);
  }
}

template<class M>
void check_is_disk(const cut_along_result<M>& cut) {
  const polygonmesh disk(cut.surface);
  const auto shape = topology_of(disk);
  CHECK(shape.edges_are_manifold);
  CHECK(shape.verts_are_manifold);
  CHECK(shape.pieces == 1);
  CHECK(shape.chi == 1);
  const auto border = boundary_loops(disk);
  CHECK(border.count == 1);
  CHECK(border.loops.size() == 1);
}

/// The rank modulo 2 of lists of edges.
template<class M>
std::size_t rank_of(const M& m, const std::vector<std::vector<edge_t<M>>>& chains) {
  std::vector<std::vector<bool>> rows;
  for (const auto& chain : chains) {
    std::vector<bool> row(edge_index_bound(m));
    for (const auto& e : chain) row[index_of(m, e)] = !row[index_of(m, e)];
    rows.push_back(row);
  }
  std::size_t rank = 0;
  for (std::size_t c = 0; c < edge_index_bound(m) && rank < rows.size(); ++c) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && !rows[pivot][c]) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[pivot], rows[rank]);
    for (std::size_t r = 0; r < rows.size(); ++r)
      if (r != rank && rows[r][c])
        for (std::size_t k = c; k < rows[r].size(); ++k) rows[r][k] = rows[r][k] != rows[rank][k];
    ++rank;
  }
  return rank;
}

/// No sum of loops bounds polys: together with the borders of polys they have the rank that they should.
template<class M>
void check_independent(const M& m, const std::vector<edge_walk<M>>& loops) {
  std::vector<std::vector<edge_t<M>>> chains;
  for (const auto p : polys(m)) {
    chains.emplace_back();
    for (const auto e : adj_p2e(m, p)) chains.back().push_back(e);
  }
  const std::size_t bounding = rank_of(m, chains);
  for (const auto& loop : loops) chains.push_back(loop.edges);
  CHECK(rank_of(m, chains) == bounding + loops.size());
}

template<class M>
void check_generators(const M& m, std::size_t expected) {
  const auto loops = homology_generators(m);
  CHECK(loops.size() == expected);
  for (const auto& loop : loops) {
    check_closed(m, loop);
    CHECK(loop.verts.front() == loops.front().verts.front());
  }
  if (expected > 0) check_is_disk(cut_along(m, loops));

  const auto cycles = homology_generators(m, {.from_root = false});
  REQUIRE(cycles.size() == expected);
  for (std::size_t i = 0; i < expected; ++i) {
    check_closed(m, cycles[i]);
    std::set<std::size_t> different;
    for (const auto& v : cycles[i].verts) different.insert(index_of(m, v));
    CHECK(different.size() == cycles[i].verts.size());
    CHECK(cycles[i].edges.size() <= loops[i].edges.size());
  }
}

}  // namespace

TEST_CASE_TEMPLATE("homology_generators: boards with holes have two loops a hole, independent, and open into a disk", M,
                   CONCINO_SURFACE_KINDS) {
  CHECK(homology_generators(M()).empty());
  for (int genus = 0; genus <= 5; ++genus) {
    const M m = from_quads<M>(holed_board(genus));
    check_generators(m, 2 * static_cast<std::size_t>(genus));
    if (genus > 2) continue;
    check_independent(m, homology_generators(m));
    check_independent(m, homology_generators(m, {.from_root = false}));
  }
}

TEST_CASE("homology_generators: of a rolled-up grid, once around either way, as short as can be") {
  for (const unsigned n : {3u, 4u, 7u})
    for (const unsigned k : {3u, 8u, 20u}) {
      const quadmesh m(rolled_grid(n, k));
      check_generators(m, 2);
      const auto loops = homology_generators(m);
      CHECK(loops[0].edges.size() == std::min(n, k));
      CHECK(loops[1].edges.size() == std::max(n, k));
    }
}

TEST_CASE_TEMPLATE("homology_generators: surfaces that are not orientable, modulo 2", M, CONCINO_SURFACE_KINDS) {
  const M bottle = from_quads<M>(rolled_grid(5, 6, true));
  check_generators(bottle, 2);
  check_independent(bottle, homology_generators(bottle));
  if constexpr (arity_v<M> != 4) {
    const M plane(projective_plane());
    check_generators(plane, 1);
    check_independent(plane, homology_generators(plane));
  }
}

TEST_CASE_TEMPLATE("homology_generators: component by component, short ones first", M, CONCINO_SURFACE_KINDS) {
  const M m = from_quads<M>(beside(beside(holed_board(2), holed_board(0)), rolled_grid(4, 9)));
  const auto loops = homology_generators(m);
  REQUIRE(loops.size() == 6);
  for (std::size_t i = 1; i < 4; ++i) {
    CHECK(loops[i].verts.front() == loops[0].verts.front());
    CHECK(loops[i].edges.size() >= loops[i - 1].edges.size());
  }
  CHECK(!(loops[4].verts.front() == loops[0].verts.front()));
  CHECK(loops[5].verts.front() == loops[4].verts.front());
  check_independent(m, loops);
  const auto shape = topology_of(polygonmesh(cut_along(m, loops).surface));
  CHECK(shape.pieces == 3);
  CHECK(shape.chi == 1 + 2 + 1);
}

TEST_CASE_TEMPLATE("homology_generators: uses nothing but a surface, and finds the same on every model", M, CONCINO_SURFACE_KINDS) {
  const M m = from_quads<M>(holed_board(1));
  const auto s = only_surface_mesh(m);
  const auto loops = homology_generators(m);
  const auto stripped = homology_generators(s);
  CHECK(loops == homology_generators(m));
  REQUIRE(stripped.size() == loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    check_closed(s, stripped[i]);
    REQUIRE(stripped[i].edges.size() == loops[i].edges.size());
    for (std::size_t k = 0; k < loops[i].edges.size(); ++k) CHECK(s.base(stripped[i].edges[k]) == loops[i].edges[k]);
  }
}

TEST_CASE("homology_generators: what is open or not manifold is refused") {
  CHECK_THROWS_WITH_AS(homology_generators(grid<trimesh>(2)), doctest::Contains("homology_generators: edge 0 has 1 poly"), invalid_mesh);
}

TEST_CASE("homology_generators: all closed surfaces of the corpus, of genus 0 to 8, and the skin of a volume") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  int highest = 0;
  for (const auto& row : rows) {
    const auto is = [&](const char* column, const char* value) { return row.column.at(column) == value; };
    if (is("boundary_loops", "n/a")) continue;  // volumes
    INFO(row.name);
    const auto m = load<polygonmesh>(row.file.string());
    if (!is("manifold", "yes") || !is("boundary_loops", "0")) {
      CHECK_THROWS_AS(homology_generators(m), invalid_mesh);
      continue;
    }
    const int genus = std::stoi(row.column.at("genus"));
    highest = std::max(highest, genus);
    check_generators(m, 2 * static_cast<std::size_t>(genus));
  }
  CHECK(highest == 8);
  CONCINO_CORPUS_OR_SKIP(file, "polyhedral/eight_voronoi.hedra");
  const auto cells = load<polyhedralmesh>(file.string());
  check_generators(boundary(cells), 6);
}
