// Searches, paths and regions on real meshes with random barriers and lengths agree with Boost.Graph on the remaining arcs.
#include <concino/graph/bfs.hpp>
#include <concino/graph/grow_regions.hpp>
#include <concino/graph/shortest_path.hpp>

#include <support/corpus_graphs.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE("corpus: bfs, dijkstra, shortest_path, grow_regions agree with Boost.Graph with random barriers") {
  for_corpus_graphs([]<class Side>(const barred_graph<Side>& g) {
    using node = typename Side::node;
    const auto& m = g.m;
    const auto graph = Side::view(m);
    const auto nodes = g.nodes();
    const auto length = g.length();
    const auto boost = make_boost_graph(g.bound(), g.arcs(length));
    const std::vector<node> sources = {nodes[g.salt % nodes.size()], nodes[g.salt / 64 % nodes.size()]};
    const std::vector<double> far[] = {boost_distances(boost, index_of(m, sources[0])), boost_distances(boost, index_of(m, sources[1]))};
    const auto steps = boost_hops(boost, index_of(m, sources[0]));

    const auto hops = bfs(graph, sources[0], {.may_enter = g.enter(), .may_cross = g.cross()});
    const auto distance = dijkstra(graph, sources, length, {.may_enter = g.enter(), .may_cross = g.cross()});
    const auto rg = grow_regions(graph, sources, length, {.may_enter = g.enter(), .may_cross = g.cross()});
    std::size_t wrong = 0;
    for (const node x : nodes) {
      const auto i = index_of(m, x);
      const double nearest = std::min(far[0][i], far[1][i]);
      wrong += hops[x] != steps[i];
      wrong += distance[x] != nearest;
      wrong += rg[x] < 0 ? nearest != std::numeric_limits<double>::infinity() : far[rg[x]][i] != nearest;
    }
    CHECK(wrong == 0);

    const auto path = shortest_path(graph, sources[0], sources[1], length, {.may_enter = g.enter(), .may_cross = g.cross()});
    double sum = path.empty() ? std::numeric_limits<double>::infinity() : 0;
    for (std::size_t i = 1; i < path.size(); ++i) sum += length(path[i - 1], path[i]);
    CHECK(sum == far[0][index_of(m, sources[1])]);
  });
}
