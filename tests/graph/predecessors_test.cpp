#include <concino/graph/predecessors.hpp>

#include <concino/graph/bfs.hpp>
#include <concino/graph/dijkstra.hpp>

#include <support/barred_graph.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// A map from nodes to nodes, of the kind of its argument.
template<class M> auto node_map(const M& m, vert_t<M>) { return make_vert_map<vert_t<M>>(m); }
template<class M> auto node_map(const M& m, poly_t<M>) { return make_poly_map<poly_t<M>>(m); }

}  // namespace

TEST_CASE_TEMPLATE("predecessors: form trees that agree with Boost's distances, on random meshes", M, CONCINO_KINDS) {
  for_random_graphs<M>(num_random_meshes(), [](const auto& g) {
    const auto& m = g.m;
    const auto nodes = g.nodes();
    using node = typename std::remove_cvref_t<decltype(g)>::node;
    if (nodes.empty()) return;
    const node s = nodes[g.salt % nodes.size()];
    const auto length = g.length();
    const auto arcs = g.arcs(length);
    const auto boost = make_boost_graph(g.bound(), arcs);
    const auto expected = boost_distances(boost, index_of(m, s));
    const auto expected_hops = boost_hops(boost, index_of(m, s));

    auto from = node_map(m, s), last = node_map(m, s);
    const auto hops = bfs(m, s, {.may_enter = g.enter(), .may_cross = g.cross(), .predecessors = &from});
    const auto distance = dijkstra(m, s, length, {.may_enter = g.enter(), .may_cross = g.cross(), .predecessors = &last});
    for (const node x : nodes) {
      const auto i = index_of(m, x);
      REQUIRE(hops[x] == expected_hops[i]);
      REQUIRE(distance[x] == expected[i]);
      if (hops[x] <= 0) {
        REQUIRE(from[x] == x);
      } else {
        REQUIRE(hops[from[x]] == hops[x] - 1);
        REQUIRE(g.has_arc(from[x], x));
        const auto path = path_to(from, x);
        REQUIRE(path.front() == s);
        REQUIRE(path.size() == static_cast<std::size_t>(hops[x]) + 1);
      }
      if (x == s || distance[x] == inf) {
        REQUIRE(last[x] == x);
      } else {
        REQUIRE(distance[last[x]] + length(last[x], x) == distance[x]);
        REQUIRE(g.has_arc(last[x], x));
        REQUIRE(path_to(last, x).front() == s);
        REQUIRE(path_to(last, x).back() == x);
      }
    }
  });
}

TEST_CASE_TEMPLATE("bfs, dijkstra: targets and bounds are obeyed on random meshes", M, CONCINO_KINDS) {
  for_random_graphs<M>(num_random_meshes(), [](const auto& g) {
    const auto& m = g.m;
    const auto nodes = g.nodes();
    if (nodes.size() < 3) return;
    const auto s = nodes[0], a = nodes[1 + g.salt % (nodes.size() - 1)], b = nodes[1 + g.salt / 64 % (nodes.size() - 1)];
    const auto hops = bfs(m, s, {.may_cross = g.cross()});
    const auto d = dijkstra(m, s, g.length(), {.may_cross = g.cross()});
    const auto far = [](auto x, auto y) { return x < 0 || y < 0 ? std::numeric_limits<int>::max() : std::max(x, y); };
    const auto near = [](auto x, auto y) { return x < 0 ? y < 0 ? std::numeric_limits<int>::max() : y : y < 0 ? x : std::min(x, y); };

    auto from = node_map(m, s);
    const auto all = bfs(m, s, {.targets = {a, b}, .may_cross = g.cross(), .predecessors = &from});
    const auto one = bfs(m, s, {.targets = {a, b}, .nearest_target = true, .may_cross = g.cross()});
    const auto two = bfs(m, s, {.may_cross = g.cross(), .max_hops = 2});
    auto last = node_map(m, s);
    const auto d_all = dijkstra(m, s, g.length(), {.targets = {a, b}, .may_cross = g.cross(), .predecessors = &last});
    const auto d_one = dijkstra(m, s, g.length(), {.targets = {a, b}, .nearest_target = true, .may_cross = g.cross()});
    const auto d_two = dijkstra(m, s, g.length(), {.may_cross = g.cross(), .max_distance = 2});
    for (const auto x : nodes) {
      REQUIRE(all[x] == (hops[x] <= far(hops[a], hops[b]) ? hops[x] : -1));
      REQUIRE(one[x] == (hops[x] <= near(hops[a], hops[b]) ? hops[x] : -1));
      REQUIRE(two[x] == (hops[x] <= 2 ? hops[x] : -1));
      REQUIRE((from[x] == x) == (all[x] <= 0));
      REQUIRE(d_all[x] == (d[x] <= std::max(d[a], d[b]) ? d[x] : inf));
      REQUIRE(d_one[x] == (d[x] <= std::min(d[a], d[b]) ? d[x] : inf));
      REQUIRE(d_two[x] == (d[x] <= 2 ? d[x] : inf));
      REQUIRE((last[x] == x) == (x == s || d_all[x] == inf));
    }
  });
}

TEST_CASE("predecessors: are stored in any map, or in none") {
  const auto m = grid<trimesh>(2);
  auto from = make_vert_map<vert_id>(m);
  std::map<vert_id, vert_id> listed;
  const auto hops = bfs(m, vert_id{0}, {.predecessors = &from});
  bfs(m, vert_id{0}, {.predecessors = &listed});
  for (const auto v : verts(m)) CHECK(from[v] == listed[v]);
  CHECK(path_to(from, vert_id{8}).size() == static_cast<std::size_t>(hops[vert_id{8}]) + 1);
  CHECK(path_to(from, vert_id{0}) == std::vector{vert_id{0}});
  std::map<vert_id, vert_id>* none = nullptr;
  CHECK(bfs(m, vert_id{0}, {.predecessors = none})[vert_id{8}] == hops[vert_id{8}]);
}

TEST_CASE("bfs, dijkstra: the first settled predecessor is kept; each source is the root of a tree") {
  const auto m = grid<quadmesh>(3);
  auto from = make_vert_map<vert_id>(m);
  bfs(m, {vert_id{15}, vert_id{0}}, {.predecessors = &from});
  CHECK(path_to(from, vert_id{14}).front() == vert_id{15});
  CHECK(path_to(from, vert_id{1}).front() == vert_id{0});
  CHECK(path_to(from, vert_id{3}).front() == vert_id{15});  // at equal distance from both sources
  auto last = make_vert_map<vert_id>(m);
  dijkstra(m, {vert_id{15}, vert_id{0}}, [](auto, auto) { return 1; }, {.predecessors = &last});
  CHECK(path_to(last, vert_id{14}).front() == vert_id{15});
}

TEST_CASE("bfs, dijkstra: bounds out of range throw") {
  const auto m = grid<trimesh>(1);
  CHECK_THROWS_WITH_AS(bfs(m, vert_id{0}, {.max_hops = -1}), "bfs: max_hops is -1; it must be 0 or more", invalid_argument);
  CHECK_THROWS_WITH_AS(dijkstra(m, vert_id{0}, {.max_distance = -1}), "dijkstra: max_distance must be 0 or more", invalid_argument);
  CHECK_THROWS_AS(dijkstra(m, vert_id{0}, {.max_distance = std::numeric_limits<double>::quiet_NaN()}), invalid_argument);
  CHECK_THROWS_WITH_AS(bfs(m, vert_id{0}, {.targets = {vert_id{9}}}), "bfs: the target is not a vert of the mesh; take one from verts(m)", invalid_mesh);
}
