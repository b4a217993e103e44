// Searches without predecessors and may_cross, from several sources, with default lengths agree with Boost.Graph on random meshes.
// The others are in predecessors_test.cpp.
#include <concino/graph/bfs.hpp>
#include <concino/graph/dijkstra.hpp>

#include <support/barred_graph.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

template<class M> vec3 place(const M& m, vert_id v) { return to_vec3(point(m, v)); }
template<class M> vec3 place(const M& m, poly_id p) { return vert_mean(m, p); }

}  // namespace

TEST_CASE_TEMPLATE("bfs, dijkstra: agree with Boost from several sources, on random meshes", M, CONCINO_KINDS) {
  for_random_graphs<M>(num_random_meshes(), [](auto g) {
    const auto& m = g.m;
    const auto nodes = g.nodes();
    if (nodes.empty()) return;
    const std::vector sources = {nodes[g.salt % nodes.size()], nodes[g.salt / 64 % nodes.size()]};
    std::fill(g.free_crossing.begin(), g.free_crossing.end(), 1);
    for (const bool barred : {true, false}) {
      if (!barred) std::fill(g.free_node.begin(), g.free_node.end(), 1);
      const auto length = g.length();
      const auto boost = make_boost_graph(g.bound(), g.arcs(length));
      const auto h0 = boost_hops(boost, index_of(m, sources[0])), h1 = boost_hops(boost, index_of(m, sources[1]));
      const auto d0 = boost_distances(boost, index_of(m, sources[0])), d1 = boost_distances(boost, index_of(m, sources[1]));
      const auto hops = barred ? bfs(m, sources, {.may_enter = g.enter()}) : bfs(m, sources);
      const auto distance = barred ? dijkstra(m, sources, length, {.may_enter = g.enter()}) : dijkstra(m, sources, length);
      for (const auto x : nodes) {
        const auto i = index_of(m, x);
        REQUIRE(hops[x] == (h0[i] < 0 ? h1[i] : h1[i] < 0 ? h0[i] : std::min(h0[i], h1[i])));
        REQUIRE(distance[x] == std::min(d0[i], d1[i]));
      }
    }
  });
}

TEST_CASE_TEMPLATE("dijkstra: default lengths are distances, on random meshes with barriers", M, CONCINO_KINDS) {
  for_random_graphs<M>(num_random_meshes(), [](const auto& g) {
    const auto& m = g.m;
    const auto nodes = g.nodes();
    if (nodes.empty()) return;
    const auto s = nodes[g.salt % nodes.size()];
    const auto straight = [&](auto a, auto b) { return norm(place(m, a) - place(m, b)); };
    const auto expected = boost_distances(make_boost_graph(g.bound(), g.arcs(straight)), index_of(m, s));
    const auto distance = dijkstra(m, s, {.may_enter = g.enter(), .may_cross = g.cross()});
    const auto given = dijkstra(m, s, straight, {.may_enter = g.enter(), .may_cross = g.cross()});
    for (const auto x : nodes) {
      const double e = expected[index_of(m, x)];
      REQUIRE((distance[x] == e || std::abs(distance[x] - e) <= 1e-13 * e));
      REQUIRE((given[x] == e || std::abs(given[x] - e) <= 1e-13 * e));
      REQUIRE((distance[x] == inf) == (e == inf));
    }
  });
}
