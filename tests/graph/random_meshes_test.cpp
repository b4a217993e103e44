// The random meshes on which algorithms are compared with Boost.Graph have all kinds of topology, and effective barriers.
#include <support/random_meshes.hpp>

#include <concino/concepts/views.hpp>
#include <concino/graph/components.hpp>
#include <concino/validate/validate.hpp>

#include <support/barred_graph.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("random meshes: are open or closed, manifold or not, connected or not, with gaps or without", M, CONCINO_KINDS) {
  std::mt19937 random(20);
  int closed = 0, manifold = 0, connected = 0, lonely = 0, gaps = 0, crowded = 0;
  const int all = 300;
  for (int i = 0; i < all; ++i) {
    const M m = random_mesh<M>(random);
    const auto r = validate(m, {.max_per_kind = 0});
    closed += r.facts.closed;
    manifold += r.facts.manifold;
    connected += r.facts.components == 1;
    lonely += r.count(defect_kind::isolated_vert) > 0;
    gaps += poly_index_bound(m) > num_polys(m);
    if constexpr (dimension_v<M> == 2) crowded += r.count(defect_kind::non_manifold_edge) > 0;
    else crowded += r.count(defect_kind::non_manifold_face) > 0;
  }
  if constexpr (dimension_v<M> == 2) CHECK(closed < all * 9 / 10);  // polys of tetmesh and hexmesh are always closed
  for (const int n : {manifold, connected, lonely, gaps, crowded}) {
    CHECK(n > all / 20);
    CHECK(n < all * 19 / 20);
  }
}

TEST_CASE_TEMPLATE("random graphs: barriers disconnect primal and dual graphs", M, CONCINO_KINDS) {
  int arcs[2] = {0, 0}, parted[2] = {0, 0}, lengths[2] = {0, 0};
  for_random_graphs<M>(300, [&](const auto& g) {
    using side = typename std::remove_cvref_t<decltype(g)>::side;
    constexpr int which = std::same_as<side, dual_side<M>>;
    const auto graph = side::view(g.m);
    const auto list = g.arcs(g.length());
    arcs[which] += list.size() > 2;
    for (const arc& a : list) lengths[which] += a.length == 0;
    parted[which] += connected_components(graph, {.may_cross = g.cross()}).count > connected_components(graph).count;
  });
  for (const int which : {0, 1}) {
    CHECK(arcs[which] > 60);
    CHECK(parted[which] > 8);
    CHECK(lengths[which] > 30);
  }
}
