#include <concino/io/skeleton_graph.hpp>

#include <concino/concepts/mesh.hpp>
#include <concino/concepts/primal_graph.hpp>
#include <concino/core/error.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/graph/boost.hpp>
#include <concino/graph/components.hpp>
#include <concino/graph/dijkstra.hpp>
#include <concino/graph/grow_regions.hpp>
#include <concino/graph/shortest_path.hpp>
#include <concino/graph/spanning_tree.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/testing/conformance.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/boost_graph.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

static_assert(PrimalGraph<skeleton> && PrimalGraph<const skeleton> && PrimalGraph<skeleton&> && Embedded<skeleton> && EmbeddedGraph<skeleton> &&
              MutablePoints<skeleton>);
static_assert(!DualGraph<skeleton> && !AnyMesh<skeleton>);

namespace {

/// A cycle of 5 verts, a tail of 2, another component of 2, and a vert without edges.
skeleton hand() {
  std::vector<vec3> points;
  for (int i = 0; i < 10; ++i) points.push_back({std::cos(i), std::sin(2 * i), 0.25 * i});
  const auto e = [](int a, int b) { return std::array{vert_id{a}, vert_id{b}}; };
  return skeleton(points, {e(4, 0), e(0, 1), e(2, 1), e(2, 3), e(3, 4), e(2, 5), e(5, 6), e(8, 7)}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
}

skeleton random_skeleton(std::mt19937& random, std::size_t n, std::size_t num_edges) {
  std::vector<vec3> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({random() % 100, random() % 100, random() % 100});
  std::set<std::pair<std::size_t, std::size_t>> all;
  for (std::size_t k = 0; k < num_edges; ++k) {
    const std::size_t a = random() % n, b = random() % n;
    if (a != b) all.insert({std::min(a, b), std::max(a, b)});
  }
  std::vector<std::array<vert_id, 2>> ends;
  for (const auto& [a, b] : all) ends.push_back({vert_id{a}, vert_id{b}});
  std::shuffle(ends.begin(), ends.end(), random);
  return skeleton(points, ends);
}

}  // namespace

TEST_CASE("skeleton: keeps the laws of graphs, and conforms") {
  CHECK(check_laws(hand()).empty());
  CHECK(check_laws(skeleton()).empty());
  const auto report = conformance([] { return hand(); });
  CHECK_MESSAGE(report.ok(), report.text());
  std::mt19937 random(8);
  for (int round = 0; round < 50; ++round) CHECK(check_laws(random_skeleton(random, 1 + random() % 30, random() % 60)).empty());
}

TEST_CASE("skeleton: verts, edges, points and radii") {
  skeleton k = hand();
  CHECK(num_verts(k) == 10);
  CHECK(num_edges(k) == 8);
  CHECK(edge_index_bound(k) == 8);
  std::vector<vert_id> neighbours;
  for (const vert_id w : adj_v2v(k, vert_id{2})) neighbours.push_back(w);
  CHECK(neighbours == std::vector<vert_id>{vert_id{1}, vert_id{3}, vert_id{5}});
  std::size_t i = 0;
  for (const edge_id e : adj_v2e(k, vert_id{2})) {
    const auto ends = adj_e2v(k, e);
    CHECK((ends[0] == vert_id{2} ? ends[1] : ends[0]) == neighbours[i++]);
  }
  CHECK(i == 3);
  CHECK(end_verts(k, edge_id{0}).first == vert_id{4});
  CHECK(k.radius(vert_id{9}) == 10);
  k.set_radius(vert_id{9}, 0.5);
  CHECK(k.radius(vert_id{9}) == 0.5);
  set_point(k, vert_id{1}, std::array<float, 3>{1, 2, 3});
  CHECK(point(k, vert_id{1}) == vec3{1, 2, 3});
  skeleton bare({{0, 0, 0}, {1, 1, 1}});
  CHECK_FALSE(bare.has_radii());
  CHECK(bare.radius(vert_id{1}) == 0);
  bare.set_radius(vert_id{1}, 3);
  CHECK(bare.radii() == std::vector<double>{0, 3});
  auto degree = make_edge_map<int>(k, 1);
  CHECK(degree[edge_id{7}] == 1);
}

TEST_CASE("skeleton: graph algorithms run on it") {
  const skeleton k = hand();
  const auto hops = bfs(k, vert_id{0});
  const int expected[] = {0, 1, 2, 2, 1, 3, 4, -1, -1, -1};
  for (unsigned v = 0; v < 10; ++v) CHECK(hops[vert_id{v}] == expected[v]);
  CHECK(connected_components(k).count == 3);
  CHECK(spanning_tree(k).edges.size() == 7);
  CHECK(bfs(k, vert_id{0}, {.may_cross = [](edge_id e) { return e != edge_id{0}; }})[vert_id{4}] == 4);
  const auto path = shortest_path(k, vert_id{6}, vert_id{0});
  CHECK(path.size() >= 4);
  CHECK(path.front() == vert_id{6});
  CHECK(path.back() == vert_id{0});
}

TEST_CASE("skeleton: shortest distances agree with those of Boost") {
  std::mt19937 random(21);
  for (int round = 0; round < 30; ++round) {
    const skeleton k = random_skeleton(random, 1 + random() % 40, random() % 80);
    const auto length = [&](vert_id a, vert_id b) {
      const vec3 d = k.point(a) - k.point(b);
      return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    };
    const auto reference = boost_distances(make_boost_graph(num_verts(k), primal_arcs(k, length)), 0);
    const auto own = dijkstra(k, vert_id{0});
    for (const vert_id v : verts(k)) CHECK((own[v] == reference[v.raw()] || std::abs(own[v] - reference[v.raw()]) <= 1e-12 * own[v]));
  }
}

TEST_CASE("skeleton: wrong edges and radii are errors") {
  const std::vector<vec3> two = {{0, 0, 0}, {1, 0, 0}};
  const vert_id a{0}, b{1};
  CHECK_THROWS_WITH_AS(skeleton(two, {{a, vert_id{2}}}), "skeleton: edge 0 has vert 2, but there are 2 verts", invalid_mesh);
  CHECK_THROWS_WITH_AS(skeleton(two, {{a, b}, {b, b}}), "skeleton: edge 1 joins vert 1 with itself", invalid_mesh);
  CHECK_THROWS_WITH_AS(skeleton(two, {{a, b}, {b, a}}), "skeleton: edges 0 and 1 join the same verts", invalid_mesh);
  CHECK_THROWS_WITH_AS(skeleton(two, {}, {1}), "skeleton: 1 radii for 2 points", invalid_argument);
}
