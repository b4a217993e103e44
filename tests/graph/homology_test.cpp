#include <concino/graph/homology.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/graph/cut_along.hpp>

#include <support/closed_surfaces.hpp>
#include <support/disk.hpp>
#include <support/generators.hpp>
#include <support/glued_surfaces.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

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

/// Checks that no sum of loops is a boundary: with the boundaries of polys, the rank is larger by the number of loops.
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

}  // namespace

TEST_CASE_TEMPLATE("homology_generators: a board has two independent loops per hole, which cut it into a disk", M,
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

TEST_CASE("homology_generators: on a torus are the two shortest loops") {
  for (const unsigned n : {3u, 4u, 7u})
    for (const unsigned k : {3u, 8u, 20u}) {
      const quadmesh m(rolled_grid(n, k));
      check_generators(m, 2);
      const auto loops = homology_generators(m);
      CHECK(loops[0].edges.size() == std::min(n, k));
      CHECK(loops[1].edges.size() == std::max(n, k));
    }
}

TEST_CASE_TEMPLATE("homology_generators: are right modulo 2 on non-orientable surfaces", M, CONCINO_SURFACE_KINDS) {
  const M bottle = from_quads<M>(rolled_grid(5, 6, true));
  check_generators(bottle, 2);
  check_independent(bottle, homology_generators(bottle));
  if constexpr (arity_v<M> != 4) {
    const M plane(projective_plane());
    check_generators(plane, 1);
    check_independent(plane, homology_generators(plane));
  }
}

TEST_CASE_TEMPLATE("homology_generators: are sorted by component and length", M, CONCINO_SURFACE_KINDS) {
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

TEST_CASE_TEMPLATE("homology_generators: run on the archetype, with the same result on every model", M, CONCINO_SURFACE_KINDS) {
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

TEST_CASE_TEMPLATE("homology_generators: are right on random closed surfaces, orientable or not", M, CONCINO_SURFACE_KINDS) {
  for_random_closed_surfaces<M>(num_random_meshes(), [](const M& m, int chi) {
    const int pieces = topology_of(m).pieces;
    if (pieces == 1) return check_generators(m, static_cast<std::size_t>(2 - chi));
    const auto loops = homology_generators(m);
    CHECK(static_cast<int>(loops.size()) == 2 * pieces - chi);
    for (const auto& loop : loops) check_closed(m, loop);
  });
}

TEST_CASE("homology_generators: throw if the surface is open or non-manifold") {
  CHECK_THROWS_WITH_AS(homology_generators(grid<trimesh>(2)), doctest::Contains("homology_generators: edge 0 has 1 poly"), invalid_mesh);
}
