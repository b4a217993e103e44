// Algorithms of Boost.Graph on views agree with concino's own. Flows are in boost_flows_test.cpp.
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/depth_first_search.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <boost/graph/prim_minimum_spanning_tree.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/graph/dijkstra.hpp>

#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <concino/graph/boost.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <vector>

using namespace concino::testing;
namespace cn = concino;

namespace {

template<class M> auto nodes_of(const cn::views::primal_view<M>& g) { return cn::verts(g.base()); }
template<class M> auto nodes_of(const cn::views::dual_view<M>& g) { return cn::polys(g.base()); }

/// A property map of Boost that writes to `values` by vertex_index.
template<class T, class G>
auto map_into(std::vector<T>& values, const G& g) {
  values.resize(num_vertices(g));
  return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, g));
}

/// A length between 1 and 2, which is the same in both directions.
constexpr auto uneven = [](std::size_t i, std::size_t j) { return 1 + static_cast<double>((7 * i * j + 3 * (i + j)) % 101) / 101; };

template<class G>
std::size_t check_components(const G& g) {
  std::vector<int> label;
  const auto k = static_cast<std::size_t>(boost::connected_components(g, map_into(label, g)));
  for (const auto v : nodes_of(g)) {
    const auto hops = cn::bfs(g, v);
    for (const auto w : nodes_of(g)) REQUIRE((label[cn::index_of(g, v)] == label[cn::index_of(g, w)]) == (hops[w] >= 0));
  }
  return k;
}

template<class G>
void check_searches(const G& g) {
  const auto source = *vertices(g).first;
  std::vector<int> steps;
  map_into(steps, g);
  std::fill(steps.begin(), steps.end(), -1);
  steps[cn::index_of(g, source)] = 0;
  const auto count = boost::record_distances(map_into(steps, g), boost::on_tree_edge());
  boost::breadth_first_search(g, source, boost::visitor(boost::make_bfs_visitor(count)));
  const auto hops = cn::bfs(g, source);
  for (const auto v : nodes_of(g)) REQUIRE(steps[cn::index_of(g, v)] == hops[v]);

  const auto length = [&](const auto& a, const auto& b) { return uneven(cn::index_of(g, a), cn::index_of(g, b)); };
  std::vector<double> far;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  boost::dijkstra_shortest_paths(g, source,
                                 boost::distance_map(map_into(far, g)).weight_map(cn::boost_weights(g, length)).distance_inf(infinity));
  const auto distance = cn::dijkstra(g, source, length);
  for (const auto v : nodes_of(g)) REQUIRE(far[cn::index_of(g, v)] == distance[v]);
}

struct counting_visitor : boost::default_dfs_visitor {
  struct counts { int roots = 0, discovered = 0, finished = 0, tree = 0; };
  counts* n;
  explicit counting_visitor(counts& c) : n(&c) {}
  template<class V, class G> void start_vertex(const V&, const G&) const { ++n->roots; }
  template<class V, class G> void discover_vertex(const V&, const G&) const { ++n->discovered; }
  template<class V, class G> void finish_vertex(const V&, const G&) const { ++n->finished; }
  template<class E, class G> void tree_edge(const E&, const G&) const { ++n->tree; }
};

template<class G>
void check_trees(const G& g, std::size_t components) {
  const auto nodes = static_cast<std::size_t>(std::distance(vertices(g).first, vertices(g).second));
  counting_visitor::counts n;
  boost::depth_first_search(g, boost::visitor(counting_visitor(n)));
  CHECK(static_cast<std::size_t>(n.roots) == components);
  CHECK(static_cast<std::size_t>(n.discovered) == nodes);
  CHECK(n.finished == n.discovered);
  CHECK(static_cast<std::size_t>(n.tree) == nodes - components);

  const auto weights = cn::boost_weights(g, [&](const auto& a, const auto& b) { return uneven(cn::index_of(g, a), cn::index_of(g, b)); });
  std::vector<typename boost::graph_traits<G>::edge_descriptor> tree;
  boost::kruskal_minimum_spanning_tree(g, std::back_inserter(tree), boost::weight_map(weights));
  CHECK(tree.size() == nodes - components);
  double kruskal = 0;
  for (const auto& e : tree) kruskal += weights[e];

  // Prim's algorithm, from one node of each component.
  double prim = 0;
  std::vector<int> label;
  boost::connected_components(g, map_into(label, g));
  std::vector<bool> done(components);
  for (const auto root : nodes_of(g)) {
    if (done[static_cast<std::size_t>(label[cn::index_of(g, root)])]) continue;
    done[static_cast<std::size_t>(label[cn::index_of(g, root)])] = true;
    std::vector<typename boost::graph_traits<G>::vertex_descriptor> parent;
    boost::prim_minimum_spanning_tree(g, map_into(parent, g), boost::weight_map(weights).root_vertex(root));
    for (const auto v : nodes_of(g)) {
      const auto p = parent[cn::index_of(g, v)];
      if (label[cn::index_of(g, v)] == label[cn::index_of(g, root)] && !(p == v)) prim += weights[edge(v, p, g).first];
    }
  }
  CHECK(prim == doctest::Approx(kruskal).epsilon(1e-12));
}

}  // namespace

TEST_CASE_TEMPLATE("boost: components, searches and trees agree on all kinds and both graphs", M, CONCINO_KINDS) {
  const M m = two_grids<M>(2);
  CHECK(check_components(cn::primal(m)) == 3);
  CHECK(check_components(cn::dual(m)) == 2);
  check_searches(cn::primal(m));
  check_searches(cn::dual(m));
  check_trees(cn::primal(m), 3);
  check_trees(cn::dual(m), 2);
}

TEST_CASE("boost: the example of the contract works with a map and with a pointer") {
  const auto m = two_grids<cn::polygonmesh>(1);
  auto map = cn::make_vert_map<int>(m);
  auto labels = cn::boost_map(map);
  auto k = boost::connected_components(cn::primal(m), labels);
  CHECK(k == 3);
  std::vector<int> array(cn::vert_index_bound(m));
  const auto pointer = boost::make_iterator_property_map(array.data(), get(boost::vertex_index, cn::primal(m)));
  CHECK(boost::connected_components(cn::primal(m), pointer) == k);
  for (const auto v : cn::verts(m)) CHECK(map[v] == array[v.raw()]);
}

TEST_CASE_TEMPLATE("boost: default weights are distances", M, cn::quadmesh, cn::polyhedralmesh) {
  const M m(jittered(grid_arrays<M>(2), 0.05));
  const auto compare = [](const auto& g, const auto& expected) {
    std::vector<double> far;
    boost::dijkstra_shortest_paths(g, *vertices(g).first, boost::distance_map(map_into(far, g)));
    for (const auto v : nodes_of(g)) REQUIRE(far[cn::index_of(g, v)] == doctest::Approx(expected[v]).epsilon(1e-12));
  };
  compare(cn::primal(m), cn::dijkstra(m, *cn::verts(m).begin()));
  compare(cn::dual(m), cn::dijkstra(m, *cn::polys(m).begin()));
}

TEST_CASE("boost: algorithms run on archetypes") {
  const auto w = user_mesh::volume_example();
  const auto p = cn::only_primal_graph(w);
  const auto d = cn::only_dual_graph(w);
  CHECK(check_components(cn::primal(p)) == 2);
  CHECK(check_components(cn::dual(d)) == 1);
  check_searches(cn::primal(p));
  check_searches(cn::dual(d));
  check_trees(cn::primal(p), 2);
  check_trees(cn::dual(d), 1);
}
