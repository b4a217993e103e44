// Searches with Boost.Graph on its compressed sparse row graph, set up for speed as its users do: colours and distances are in arrays that are allocated
// once, and edge lengths are either stored beforehand or computed during the search.
#pragma once

#include "../floor/graph.hpp"

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace bench::peers {

using floors::u32;

struct stored_length { double length; };
using csr_graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, stored_length, boost::no_property, u32, u32>;

inline double distance(const double* points, u32 a, u32 b) {
  const double *p = points + 3 * std::size_t{a}, *q = points + 3 * std::size_t{b};
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  return std::sqrt(x * x + y * y + z * z);
}

template<u32 Stride>
csr_graph make_csr(const floors::rows<Stride>& g, const double* points) {
  std::vector<std::pair<u32, u32>> arcs;
  std::vector<stored_length> lengths;
  for (u32 i = 0; i < g.size; ++i)
    for (u32 k = g.first(i); k != g.last(i); ++k)
      if (g.adj[k] != floors::none) {
        arcs.emplace_back(i, g.adj[k]);
        lengths.push_back({distance(points, i, g.adj[k])});
      }
  return csr_graph(boost::edges_are_sorted, arcs.begin(), arcs.end(), lengths.begin(), g.size);
}

class searches {
  const csr_graph& g_;
  std::vector<int> hops_;
  std::vector<double> distances_;
  std::vector<boost::default_color_type> colors_;

  auto colors() { return boost::make_iterator_property_map(colors_.begin(), get(boost::vertex_index, g_)); }
  auto distances() { return boost::make_iterator_property_map(distances_.begin(), get(boost::vertex_index, g_)); }
  template<class W>
  const std::vector<double>& dijkstra(u32 source, W weights) {
    boost::dijkstra_shortest_paths(g_, source, boost::weight_map(weights).distance_map(distances()).color_map(colors()));
    return distances_;
  }

 public:
  explicit searches(const csr_graph& g) : g_(g), hops_(num_vertices(g)), distances_(num_vertices(g)), colors_(num_vertices(g)) {}

  const std::vector<int>& bfs(u32 source) {
    std::fill(hops_.begin(), hops_.end(), -1);
    hops_[source] = 0;
    const auto hops = boost::make_iterator_property_map(hops_.begin(), get(boost::vertex_index, g_));
    const auto visitor = boost::make_bfs_visitor(boost::record_distances(hops, boost::on_tree_edge()));
    boost::breadth_first_search(g_, source, boost::visitor(visitor).color_map(colors()));
    return hops_;
  }
  const std::vector<double>& dijkstra(u32 source) { return dijkstra(source, get(&stored_length::length, g_)); }
  const std::vector<double>& dijkstra_measuring(u32 source, const double* points) {
    using arc = boost::graph_traits<csr_graph>::edge_descriptor;
    const auto length = [points, this](arc e) { return distance(points, boost::source(e, g_), boost::target(e, g_)); };
    return dijkstra(source, boost::make_function_property_map<arc>(length));
  }
};

}  // namespace bench::peers
