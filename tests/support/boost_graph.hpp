// Reference results for graph tests: copies the primal or dual graph of a mesh to Boost.Graph, and runs Boost's algorithms on it.
#pragma once

#include <concino/concepts/dual_graph.hpp>
#include <concino/concepts/primal_graph.hpp>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <limits>
#include <utility>
#include <vector>

namespace concino::testing {

struct arc { std::size_t from, to; double length; };

using boost_graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, double>;

inline boost_graph make_boost_graph(std::size_t nodes, const std::vector<arc>& arcs) {
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  std::vector<double> lengths;
  for (const arc& a : arcs) {
    ends.push_back({a.from, a.to});
    lengths.push_back(a.length);
  }
  return boost_graph(boost::edges_are_unsorted_multi_pass, ends.begin(), ends.end(), lengths.begin(), nodes);
}

/// The arcs of all edges in both directions, in the order of adj_v2v; length(v, w) as for dijkstra.
template<class M, class L>
std::vector<arc> primal_arcs(const M& m, const L& length) {
  std::vector<arc> r;
  for (const vert_t<M> v : verts(m))
    for (const vert_t<M> w : adj_v2v(m, v)) r.push_back({index_of(m, v), index_of(m, w), length(v, w)});
  return r;
}

template<class M, class L>
std::vector<arc> dual_arcs(const M& m, const L& length) {
  std::vector<arc> r;
  for (const poly_t<M> p : polys(m))
    for (const poly_t<M> q : adj_p2p(m, p)) r.push_back({index_of(m, p), index_of(m, q), length(p, q)});
  return r;
}

/// Shortest distances by Boost; +inf where unreached.
inline std::vector<double> boost_distances(const boost_graph& g, std::size_t source) {
  std::vector<double> d(num_vertices(g));
  boost::dijkstra_shortest_paths(g, source,
                                 boost::weight_map(get(boost::edge_bundle, g))
                                     .distance_map(boost::make_iterator_property_map(d.begin(), get(boost::vertex_index, g)))
                                     .distance_inf(std::numeric_limits<double>::infinity()));
  return d;
}

/// Numbers of edges from the source by Boost; -1 where unreached.
inline std::vector<int> boost_hops(const boost_graph& g, std::size_t source) {
  std::vector<int> h(num_vertices(g), -1);
  h[source] = 0;
  const auto map = boost::make_iterator_property_map(h.begin(), get(boost::vertex_index, g));
  boost::breadth_first_search(g, source, boost::visitor(boost::make_bfs_visitor(boost::record_distances(map, boost::on_tree_edge()))));
  return h;
}

}  // namespace concino::testing
