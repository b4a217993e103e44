// Algorithms of Boost.Graph give the same results on views of random meshes, some with gaps in the indices, and on copies of the graphs.
#include <concino/core/function_ref.hpp>
#include <concino/graph/boost.hpp>

#include <support/barred_graph.hpp>

#include <boost/graph/filtered_graph.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <vector>

using namespace concino::testing;
namespace cn = concino;

namespace {

/// Checks the labels and the number of components of open nodes. In the copied graph, gaps and closed nodes are isolated.
template<class G>
void check_labels(const G& g, const std::vector<int>& label, int count) {
  const auto expected = boost_components(make_undirected(g, g.even_length()));
  std::map<int, int> number;
  for (const auto x : g.nodes()) {
    const auto i = cn::index_of(g.m, x);
    if (g.free_node[i]) REQUIRE(label[i] == number.emplace(expected[i], static_cast<int>(number.size())).first->second);
  }
  REQUIRE(count == static_cast<int>(number.size()));
}

/// Runs algorithms on the view and on a copy.
template<class G>
void check_views(const G& g) {
  const auto view = G::side::view(g.m);
  const auto nodes = g.nodes();
  const auto index = get(boost::vertex_index, view);
  REQUIRE(num_vertices(view) == g.bound());
  REQUIRE(static_cast<std::size_t>(std::distance(vertices(view).first, vertices(view).second)) == nodes.size());
  if (nodes.empty()) return;  // Boost's connected_components needs at least one node

  const auto length = g.even_length();
  const auto weights = cn::boost_weights(view, length);
  std::vector<int> label(g.bound(), -1);
  const int count = boost::connected_components(view, boost::make_iterator_property_map(label.begin(), index));
  check_labels(g, label, count);

  std::vector<typename boost::graph_traits<decltype(view)>::edge_descriptor> tree;
  boost::kruskal_minimum_spanning_tree(view, std::back_inserter(tree), boost::weight_map(weights));
  double weight = 0;
  for (const auto& e : tree) weight += weights[e];
  REQUIRE(tree.size() == nodes.size() - static_cast<std::size_t>(count));
  REQUIRE(weight == boost_tree_weight(make_undirected(g, length)));

  const auto s = nodes[g.salt % nodes.size()];
  std::vector<double> far(g.bound());
  boost::dijkstra_shortest_paths(view, s,
                                 boost::weight_map(weights)
                                     .distance_map(boost::make_iterator_property_map(far.begin(), index))
                                     .distance_inf(std::numeric_limits<double>::infinity()));
  const auto expected = boost_distances(make_boost_graph(g.bound(), g.arcs(length)), index[s]);
  for (const auto x : nodes) REQUIRE(far[index[x]] == expected[index[x]]);
}

/// Excludes closed nodes by boost::filtered_graph.
template<class G>
void check_filter(const G& g) {
  const auto view = G::side::view(g.m);
  const auto index = get(boost::vertex_index, view);
  const auto enter = g.enter();
  const boost::filtered_graph part(view, boost::keep_all(), cn::function_ref<bool(typename G::node)>(enter));
  if (vertices(part).first == vertices(part).second) return;
  std::vector<int> label(g.bound(), -1);
  const int count = boost::connected_components(part, boost::make_iterator_property_map(label.begin(), index));
  check_labels(g, label, count);
}

}  // namespace

TEST_CASE_TEMPLATE("boost: components, trees and shortest paths are right on random meshes", M, CONCINO_KINDS) {
  for_random_graphs<M>(num_random_meshes(), [](auto g) {
    std::fill(g.free_crossing.begin(), g.free_crossing.end(), 1);
    std::fill(g.free_node.begin(), g.free_node.end(), 1);
    check_views(g);
  });
}

TEST_CASE_TEMPLATE("boost: a filter excludes the same as may_enter, on random meshes", M, cn::polygonmesh, cn::tetmesh) {
  for_random_graphs<M>(num_random_meshes(), [](auto g) {
    std::fill(g.free_crossing.begin(), g.free_crossing.end(), 1);
    check_filter(g);
  });
}

namespace {

template<class G>
std::size_t edges_met(const G& g) {
  using namespace concino;  // with this directive, the names of two functions must be qualified
  std::size_t n = 0;
  for (auto [e, last] = concino::views::edges(g); e != last; ++e) ++n;
  CHECK(concino::views::num_edges(g) == n);
  return n;
}

}  // namespace

TEST_CASE("boost: views work with a using-directive for concino") {
  const auto m = grid<cn::quadmesh>(2);
  CHECK(edges_met(cn::primal(m)) == 12);
  CHECK(edges_met(cn::dual(m)) == 4);
}
