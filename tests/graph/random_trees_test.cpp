// Spanning trees on random meshes with barriers agree with Boost's.
#include <concino/graph/spanning_tree.hpp>

#include <concino/graph/components.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <support/barred_graph.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The arcs as pairs of indices, the smaller one first.
template<class M, class T>
std::set<std::pair<std::size_t, std::size_t>> ends(const M& m, const T& tree) {
  std::set<std::pair<std::size_t, std::size_t>> r;
  for (const auto& [a, b] : tree.arcs) r.insert(std::minmax<std::size_t>(index_of(m, a), index_of(m, b)));
  return r;
}

}  // namespace

TEST_CASE_TEMPLATE("spanning_tree: is a spanning tree with the weight of Boost's, on random meshes", M, CONCINO_KINDS) {
  for_random_graphs<M>(num_random_meshes(), [](const auto& g) {
    using side = typename std::remove_cvref_t<decltype(g)>::side;
    const auto graph = side::view(g.m);
    const auto length = g.even_length();
    const auto boost = make_undirected(g, length);
    const auto cc = connected_components(graph, {.may_enter = g.enter(), .may_cross = g.cross()});
    std::size_t nodes = 0;
    for (const auto x : g.nodes()) nodes += cc[x] >= 0;

    const auto tree = spanning_tree(graph, length, {.may_enter = g.enter(), .may_cross = g.cross()});
    REQUIRE(tree.arcs.size() == nodes - static_cast<std::size_t>(cc.count));
    disjoint_sets sets(g.bound());
    double weight = 0;
    for (const auto& [a, b] : tree.arcs) {
      REQUIRE(sets.unite(index_of(g.m, a), index_of(g.m, b)));
      REQUIRE(index_of(g.m, a) < index_of(g.m, b));
      REQUIRE((g.has_arc(a, b) && g.has_arc(b, a)));
      weight += length(a, b);
    }
    REQUIRE(tree.weight == weight);
    REQUIRE(weight == boost_tree_weight(boost));
    if constexpr (requires { tree.edges; }) {
      REQUIRE(tree.edges.size() == tree.arcs.size());
      for (std::size_t i = 0; i < tree.edges.size(); ++i) {
        auto&& at = adj_e2v(g.m, tree.edges[i]);
        const auto a = *at.begin(), b = *std::next(at.begin());
        REQUIRE(std::minmax(a, b) == std::minmax(tree.arcs[i].first, tree.arcs[i].second));
        REQUIRE(g.cross()(tree.edges[i]));
      }
    }

    const auto grown = spanning_tree(graph, length, {.method = tree_method::prim, .may_enter = g.enter(), .may_cross = g.cross()});
    REQUIRE(grown.weight == weight);
    REQUIRE(ends(g.m, grown) == ends(g.m, tree));
    std::vector<char> reached(g.bound());
    for (const auto& [a, b] : grown.arcs) {  // from the first node of each component outwards
      const auto i = index_of(g.m, a), j = index_of(g.m, b);
      REQUIRE(!reached[j]);
      reached[i] = reached[j] = 1;
    }

    // The longest tree is the shortest one for negative lengths, and the first one in the reversed order.
    const auto longest = spanning_tree(graph, [&](auto a, auto b) { return -length(a, b); }, {.may_enter = g.enter(), .may_cross = g.cross()});
    const auto before = [&](const auto& a, const auto& b) { return length(a.first, a.second) > length(b.first, b.second); };
    for (const auto method : {tree_method::kruskal, tree_method::prim}) {
      const auto by_order = spanning_tree(graph, length, {.method = method, .before = before, .may_enter = g.enter(), .may_cross = g.cross()});
      REQUIRE(by_order.weight == -longest.weight);
      REQUIRE(ends(g.m, by_order) == ends(g.m, longest));
    }
  });
}
