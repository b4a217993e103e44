// Models: the primal graph of a mesh in three graph classes of Boost.
#pragma once

#include <concino/adapters/boost_graph.hpp>

#include <agreement/run.hpp>

namespace concino::agreement {

struct numbered_list {
  static constexpr const char* name = "adjacency_list";
  template<class F>
  static void make(std::size_t n, const std::vector<std::pair<std::size_t, std::size_t>>& arcs, F&& f) {
    f(boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS>(arcs.begin(), arcs.end(), n));
  }
};
struct compressed_rows {
  static constexpr const char* name = "compressed_sparse_row_graph";
  template<class F>
  static void make(std::size_t n, const std::vector<std::pair<std::size_t, std::size_t>>& arcs, F&& f) {
    f(boost::compressed_sparse_row_graph<>(boost::edges_are_unsorted_multi_pass, arcs.begin(), arcs.end(), n));
  }
};
struct seen_through_a_view {
  static constexpr const char* name = "graph_view(...)";
  template<class F>
  static void make(std::size_t n, const std::vector<std::pair<std::size_t, std::size_t>>& arcs, F&& f) {
    boost::adjacency_list<boost::setS, boost::listS, boost::directedS, boost::property<boost::vertex_index_t, std::size_t>> g(arcs.begin(), arcs.end(), n);
    std::size_t i = 0;
    for (auto [v, last] = vertices(g); v != last; ++v) put(boost::vertex_index, g, *v, i++);
    f(graph_view(g));
  }
};

template<class K, class Graph>
struct boost_graph_of {
  using kind = K;
  static constexpr const char* column = "Boost.Graph";
  static constexpr const char* name = Graph::name;
  static constexpr bool any_surface = true, gaps = true;

  template<class Arrays, class F>
  static void with(const input<Arrays>& in, F&& f) {
    const auto m = reference<K>(in);
    std::vector<std::pair<std::size_t, std::size_t>> arcs;
    for (const auto v : verts(m))
      for (const auto w : adj_v2v(m, v)) arcs.emplace_back(v.raw(), w.raw());
    Graph::make(num_verts(m), arcs, [&](const auto& g) { f(g); });
  }
};

using boost_graphs =
    models<boost_graph_of<trimesh, numbered_list>, boost_graph_of<polygonmesh, compressed_rows>, boost_graph_of<hexmesh, seen_through_a_view>>;

}  // namespace concino::agreement
