#include <concino/operators/uniform.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/mesh.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("uniform: every edge has weight 1, and every vert mass 1", M, CONCINO_KINDS) {
  const auto mesh = grid<M>(1);
  const auto g = only_primal_graph(mesh);
  static_assert(Discretisation<uniform_t, decltype(g)>);
  const auto weight = uniform.neighbour_weights(g);
  const auto mass = uniform.masses(g);
  for (const auto v : verts(g)) {
    CHECK(mass[v] == 1);
    for (const auto w : adj_v2v(g, v)) CHECK(weight(v, w) == 1);
  }
}
