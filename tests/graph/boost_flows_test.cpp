// Maximum flows by algorithms of Boost.Graph on views are right: there is a cut of the same value.
#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/graph/boost.hpp>

#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <boost/graph/betweenness_centrality.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/edmonds_karp_max_flow.hpp>
#include <boost/graph/push_relabel_max_flow.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace concino::testing;
namespace cn = concino;

namespace {

/// The source and the sink of the flow: the first node, and the farthest of its component.
template<class G>
auto ends_of_flow(const G& undirected) {
  const auto s = *vertices(undirected).first;
  auto t = s;
  const auto hops = cn::bfs(undirected, s);
  for (auto [v, last] = vertices(undirected); v != last; ++v)
    if (hops[*v] > hops[t]) t = *v;
  return std::pair(s, t);
}

/// Checks that the flow obeys the capacities and that a cut has the same value, so that both are optimal.
template<class G>
void check_flow(const G& undirected) {
  const auto [s, t] = ends_of_flow(undirected);
  const auto g = cn::directed(undirected);
  const auto index = get(boost::vertex_index, g);
  const auto reverse = get(boost::edge_reverse, g);
  const auto uneven = [&](const auto& a, const auto& b) { return static_cast<int>((5 * index[a] + 11 * index[b]) % 13); };
  const auto capacity = cn::boost_edge_map<int>(g, uneven);
  const auto residual = cn::boost_edge_map<int>(g);
  std::vector<boost::default_color_type> side(num_vertices(g));
  const auto side_map = boost::make_iterator_property_map(side.begin(), index);
  const int flow = boost::boykov_kolmogorov_max_flow(g, capacity, residual, reverse, side_map, index, s, t);

  // Boost does not update the residual opposite to arcs at source and sink. So the flow of an arc is only used where it is positive.
  const auto along = [&](const auto& a) { return std::max(0, capacity[a] - residual[a]); };
  int cut = 0;
  for (auto [e, last] = edges(g); e != last; ++e) {
    if (side_map[source(*e, g)] == boost::black_color && side_map[target(*e, g)] != boost::black_color) cut += capacity[*e];
    REQUIRE(residual[*e] >= 0);
  }
  for (auto [v, end] = vertices(g); v != end; ++v) {
    int net = 0;
    for (auto [e, last] = out_edges(*v, g); e != last; ++e) net += along(*e);
    for (auto [e, last] = in_edges(*v, g); e != last; ++e) net -= along(*e);
    REQUIRE(net == (*v == s ? flow : *v == t ? -flow : 0));
  }
  CHECK(flow == cut);
  CHECK(flow > 0);

  const auto again = cn::boost_edge_map<int>(g);
  const auto maps = boost::capacity_map(capacity).residual_capacity_map(again).reverse_edge_map(reverse);
  CHECK(boost::edmonds_karp_max_flow(g, s, t, maps) == flow);
}

}  // namespace

TEST_CASE_TEMPLATE("boost: maximum flows of two algorithms agree on all kinds and both graphs", M, CONCINO_KINDS) {
  const M m = two_grids<M>(2);
  check_flow(cn::primal(m));
  check_flow(cn::dual(m));
}

TEST_CASE("boost: flows run on archetypes") {
  const auto w = user_mesh::volume_example();
  const auto p = cn::only_primal_graph(w);
  const auto d = cn::only_dual_graph(w);
  check_flow(cn::primal(p));
  check_flow(cn::dual(d));
}

TEST_CASE_TEMPLATE("boost: preflows work if no arc has capacity in both directions", M, cn::polygonmesh, cn::tetmesh) {
  const M m = two_grids<M>(2);
  const auto [s, t] = ends_of_flow(cn::primal(m));
  const auto hops = cn::bfs(m, s);
  const auto g = cn::directed(cn::primal(m));
  const auto index = get(boost::vertex_index, g);
  const auto reverse = get(boost::edge_reverse, g);
  const auto outwards = [&](auto a, auto b) { return hops[a] < hops[b] ? static_cast<int>(1 + (5 * index[a] + 11 * index[b]) % 13) : 0; };
  const auto capacity = cn::boost_edge_map<int>(g, outwards);
  const auto residual = cn::boost_edge_map<int>(g), again = cn::boost_edge_map<int>(g);
  const int flow = boost::push_relabel_max_flow(g, s, t, capacity, residual, reverse, index);
  CHECK(flow > 0);
  CHECK(flow == boost::boykov_kolmogorov_max_flow(g, capacity, again, reverse, index, s, t));
}

TEST_CASE("boost: the flow between corners of a grid is the capacity of their edges") {
  const auto m = grid<cn::quadmesh>(4);
  const auto g = cn::directed(cn::primal(m));
  const auto residual = cn::boost_edge_map<double>(g);
  const auto straight = get(boost::edge_weight, g);
  const auto reverse = get(boost::edge_reverse, g);
  const auto index = get(boost::vertex_index, g);
  CHECK(boost::boykov_kolmogorov_max_flow(g, straight, residual, reverse, index, cn::vert_id{0}, cn::vert_id{24}) == 0.5);
}

TEST_CASE("boost: betweenness centrality is right on a path of polys") {
  cn::quadmesh m({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {3, 1, 0}, {4, 1, 0}},
                 {{0, 1, 6, 5}, {1, 2, 7, 6}, {2, 3, 8, 7}, {3, 4, 9, 8}});
  const auto g = cn::dual(m);
  auto through = cn::make_poly_map<double>(m);
  const auto over = cn::boost_edge_map<double>(g);
  boost::brandes_betweenness_centrality(g, boost::centrality_map(cn::boost_map(through)).edge_centrality_map(over));
  const double nodes[] = {0, 2, 2, 0}, arcs[] = {3, 4, 3};
  for (unsigned i = 0; i < 4; ++i) CHECK(through[cn::poly_id{i}] == nodes[i]);
  for (unsigned i = 0; i < 3; ++i) CHECK(over[edge(cn::poly_id{i + 1}, cn::poly_id{i}, g).first] == arcs[i]);
}
