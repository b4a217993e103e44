// Ties between equal paths are broken as documented, and a search visits no more elements than necessary.
#include <concino/graph/bfs.hpp>
#include <concino/graph/dijkstra.hpp>

#include <support/barred_graph.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M> auto node_map(const M& m, vert_t<M>) { return make_vert_map<vert_t<M>>(m); }
template<class M> auto node_map(const M& m, poly_t<M>) { return make_poly_map<poly_t<M>>(m); }

}  // namespace

TEST_CASE_TEMPLATE("bfs: the predecessor is the first one reached, on random meshes", M, CONCINO_KINDS) {
  for_random_graphs<M>(num_random_meshes(), [](const auto& g) {
    using side = typename std::remove_cvref_t<decltype(g)>::side;
    const auto graph = side::view(g.m);
    const auto nodes = g.nodes();
    if (nodes.empty()) return;
    std::vector queue = {nodes[g.salt % nodes.size()], nodes[g.salt / 64 % nodes.size()]};
    auto from = node_map(g.m, queue[0]), expected = from;
    const auto hops = bfs(graph, queue, {.may_enter = g.enter(), .predecessors = &from});
    std::vector<char> met(g.bound());
    for (const auto x : nodes) expected[x] = x;
    for (const auto s : queue) met[index_of(g.m, s)] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const auto v = queue[i];
      const auto visit = [&](const auto& around) {
        for (const auto w : around)
          if (!met[index_of(g.m, w)] && g.enter()(w)) {
            met[index_of(g.m, w)] = 1;
            expected[w] = v;
            queue.push_back(w);
          }
      };
      if constexpr (std::same_as<side, primal_side<M>>) visit(adj_v2v(g.m, v));
      else visit(adj_p2p(g.m, v));
    }
    for (const auto x : nodes) {
      REQUIRE(from[x] == expected[x]);
      REQUIRE((hops[x] >= 0) == (met[index_of(g.m, x)] != 0));
    }
  });
}

TEST_CASE_TEMPLATE("dijkstra: among equal predecessors the first settled is kept, on random meshes", M, CONCINO_KINDS) {
  for_random_graphs<M>(num_random_meshes(), [](const auto& g) {
    const auto nodes = g.nodes();
    if (nodes.empty()) return;
    const auto s = nodes[g.salt % nodes.size()];
    std::vector<typename std::remove_cvref_t<decltype(g)>::node> settled;  // a node is settled when dijkstra asks for the lengths of its arcs
    const auto length = [&](auto a, auto b) {
      if (settled.empty() || !(settled.back() == a)) settled.push_back(a);
      return g.length()(a, b);
    };
    auto last = node_map(g.m, s), again = last;
    const auto distance = dijkstra(g.m, s, length, {.may_enter = g.enter(), .may_cross = g.cross(), .predecessors = &last});
    std::vector<std::size_t> rank(g.bound(), settled.size()), first(g.bound(), settled.size());
    for (std::size_t i = settled.size(); i-- > 0;) rank[index_of(g.m, settled[i])] = i;
    std::vector<double> d(g.bound());
    for (const auto x : nodes) d[index_of(g.m, x)] = distance[x];
    for (const arc& a : g.arcs(g.length()))
      if (d[a.from] + a.length == d[a.to]) first[a.to] = std::min(first[a.to], rank[a.from]);
    dijkstra(g.m, s, g.length(), {.may_enter = g.enter(), .may_cross = g.cross(), .predecessors = &again});
    for (std::size_t i = 1; i < settled.size(); ++i) REQUIRE(distance[settled[i - 1]] <= distance[settled[i]]);
    for (const auto x : nodes) {
      const bool reached = !(x == s) && distance[x] < std::numeric_limits<double>::infinity();
      REQUIRE(last[x] == (reached ? settled[first[index_of(g.m, x)]] : x));
      REQUIRE(again[x] == last[x]);
    }
  });
}

TEST_CASE_TEMPLATE("bfs, dijkstra: elements beyond targets and bounds are not visited", M, CONCINO_KINDS) {
  const M m = grid<M>(6);
  const auto count = [&](const auto& s, const auto& near, const auto& far) {
    std::size_t asked = 0;
    const auto enter = [&](auto) { return ++asked > 0; };
    const auto one = [](auto, auto) { return 1.0; };
    const auto cost = [&](const auto& search) {
      asked = 0;
      search();
      return asked;
    };
    const std::size_t everything = cost([&] { bfs(m, s, {.may_enter = enter}); });
    CHECK(cost([&] { bfs(m, s, {.targets = {near}, .may_enter = enter}); }) < everything / 4);
    CHECK(cost([&] { bfs(m, s, {.targets = {near, far}, .nearest_target = true, .may_enter = enter}); }) < everything / 4);
    CHECK(cost([&] { bfs(m, s, {.targets = {near, far}, .may_enter = enter}); }) > everything / 4);
    CHECK(cost([&] { bfs(m, s, {.may_enter = enter, .max_hops = 1}); }) < everything / 4);
    CHECK(cost([&] { bfs(m, s, {.may_enter = enter, .max_hops = 0}); }) == 0);
    const std::size_t all_arcs = cost([&] { dijkstra(m, s, one, {.may_enter = enter}); });
    CHECK(cost([&] { dijkstra(m, s, one, {.targets = {near}, .may_enter = enter}); }) < all_arcs / 4);
    CHECK(cost([&] { dijkstra(m, s, one, {.targets = {near, far}, .nearest_target = true, .may_enter = enter}); }) < all_arcs / 4);
    CHECK(cost([&] { dijkstra(m, s, one, {.targets = {near, far}, .may_enter = enter}); }) > all_arcs / 4);
    CHECK(cost([&] { dijkstra(m, s, one, {.may_enter = enter, .max_distance = 1}); }) < all_arcs / 4);
  };
  count(vert_id{0}, *adj_v2v(m, vert_id{0}).begin(), vert_id{static_cast<unsigned>(num_verts(m) - 1)});
  count(poly_id{0}, *adj_p2p(m, poly_id{0}).begin(), poly_id{static_cast<unsigned>(num_polys(m) - 1)});
}
