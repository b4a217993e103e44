// The edges along which a discretisation of the Laplacian couples verts.
#pragma once

#include <concino/graph/bfs.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/operators/discretisation.hpp>

#include <vector>

namespace concino::detail {

/// All edges of a graph whose neighbours have weights. Otherwise the edges of polys, and others to which the
/// discretisation gives a weight: where a poly was deleted and its edges were kept, integrals over polys do not couple
/// their ends.
template<class M, class D>
class coupling_edges {
  static constexpr bool has_all = requirement::has_neighbour_weights<D, M>;

  const M& m_;
  std::vector<unsigned char> is_omitted_;  // by edge; empty if no edge is omitted

 public:
  /// Errors: those of the weights of the discretisation.
  coupling_edges(const M& m, [[maybe_unused]] const D& discretisation) : m_(m) {
    if constexpr (!has_all) {
      std::vector<edge_t<M>> without_poly;
      for (const edge_t<M> e : edges(m)) {
        const auto& around = adj_e2p(m, e);
        if (!(around.begin() != around.end())) without_poly.push_back(e);
      }
      if (without_poly.empty()) return;
      is_omitted_.assign(edge_index_bound(m), 0);
      if constexpr (requirement::has_edge_weights<D, M>) {
        const auto weight = discretisation.edge_weights(m);
        for (const edge_t<M> e : without_poly) is_omitted_[index_of(m, e)] = static_cast<double>(weight[e]) == 0;
      } else {
        for (const edge_t<M> e : without_poly) is_omitted_[index_of(m, e)] = 1;
      }
    }
  }

  /// Whether a vert has such an edge.
  bool has_any(const vert_t<M>& v) const {
    if constexpr (!has_all)
      if (!is_omitted_.empty()) {
        for (const edge_t<M> e : adj_v2e(m_, v))
          if (!is_omitted_[index_of(m_, e)]) return true;
        return false;
      }
    const auto& around = adj_v2v(m_, v);
    return around.begin() != around.end();
  }

  /// Hops along these edges.
  vert_map<M, int> bfs(const std::vector<vert_t<M>>& sources) const {
    if constexpr (!has_all)
      if (!is_omitted_.empty())
        return concino::bfs(m_, sources,
                            {.may_cross = [this](const edge_t<M>& e) { return !is_omitted_[index_of(m_, e)]; }});
    return concino::bfs(m_, sources);
  }
};

}  // namespace concino::detail
