// Connected components of real meshes, with and without random barriers, agree with Boost.Graph.
#include <concino/graph/components.hpp>
#include <concino/graph/grow_regions.hpp>

#include <support/corpus_graphs.hpp>

#include <doctest/doctest.h>

#include <map>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The seeds: the first node of each component.
template<class Side>
std::vector<typename Side::node> check_components(const barred_graph<Side>& g) {
  using node = typename Side::node;
  const auto cc = connected_components(Side::view(g.m), {.may_enter = g.enter(), .may_cross = g.cross()});
  const auto expected = boost_components(make_undirected(g, g.even_length()));
  std::map<int, int> number;  // by Boost's labels
  std::vector<node> firsts;
  std::size_t wrong = 0;
  for (const node x : g.nodes()) {
    const auto i = index_of(g.m, x);
    if (!g.free_node[i]) {
      wrong += cc[x] != -1;
      continue;
    }
    const auto found = number.emplace(expected[i], static_cast<int>(number.size()));
    wrong += cc[x] != found.first->second;
    if (found.second) firsts.push_back(x);
  }
  CHECK(wrong == 0);
  CHECK(cc.count == static_cast<int>(number.size()));
  return firsts;
}

}  // namespace

TEST_CASE("corpus: components agree with Boost.Graph on verts and polys of every mesh") {
  for_corpus_graphs([]<class Side>(barred_graph<Side>& g) {
    check_components(g);
    tear_down_walls(g);
    const auto seeds = check_components(g);
    const auto graph = Side::view(g.m);
    const auto cc = connected_components(graph);
    const auto rg = grow_regions(graph, seeds, [](auto, auto) { return true; });
    std::size_t wrong = 0;
    for (const auto x : g.nodes()) wrong += rg[x] != cc[x];
    CHECK(wrong == 0);
  });
}
