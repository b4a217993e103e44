#include <concino/geometry/edge_length.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("edge_length: is right on grids, scales exactly, and is the same on the archetype", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  const auto length = edge_lengths(m);
  double shortest = 9, longest = 0;
  for (const auto e : edges(m)) {
    CHECK(length[e] == edge_length(m, e));
    shortest = std::min(shortest, length[e]);
    longest = std::max(longest, length[e]);
  }
  const double step = arity_v<M> == 0 ? 0.25 : 0.5;
  CHECK(shortest == step);
  const double diagonal = arity_v<M> == 3 ? std::sqrt(0.5) : arity_v<M> == 4 && VolumeMesh<M> ? std::sqrt(0.75) : 0.0;
  CHECK(longest == doctest::Approx(diagonal > 0 ? diagonal : arity_v<M> == 0 && SurfaceMesh<M> ? 0.25 : 0.5));

  const auto arrays = jittered(grid_arrays<M>(2), 0.1);
  const M wild(arrays), large(scaled(arrays, 0x1p400)), small(scaled(arrays, 0x1p-400));
  const auto g = only_embedded_mesh(wild);
  const auto stripped = edge_lengths(g);
  for (const auto e : edges(wild)) {
    CHECK(edge_length(large, e) == 0x1p400 * edge_length(wild, e));
    CHECK(edge_length(small, e) == 0x1p-400 * edge_length(wild, e));
    CHECK(stripped[g.edge(e)] == edge_length(wild, e));
  }
}

TEST_CASE_TEMPLATE("edge_lengths: an empty mesh has none", M, CONCINO_KINDS) {
  const M m;
  CHECK(edge_lengths(m).values().empty());
}

TEST_CASE("edge_length: is 0 if both ends coincide") {
  const trimesh m({{1, 2, 3}, {1, 2, 3}, {4, 5, 6}}, {{0, 1, 2}});
  CHECK(edge_length(m, edge_id{0}) == 0);
}
