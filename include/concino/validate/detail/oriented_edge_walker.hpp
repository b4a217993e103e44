// Traverses one polygon after another and reports the direction of each of its edges.
#pragma once

#include <concino/concepts/mesh.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// The concepts do not require that adj_p2e has the order of adj_p2v, so the ends of edges are looked up by the
/// position of verts in the polygon.
template<class M>
class oriented_edge_walker {
  std::vector<std::uint64_t> position_;  // by vert index: 1 + the number of verts visited before, over all polygons
  std::uint64_t next_ = 1;

 public:
  struct summary {
    std::uint32_t verts = 0;
    bool repeats = false;  // some vert occurs twice
    bool is_degenerate() const { return verts < 3 || repeats; }
  };

  explicit oriented_edge_walker(const M& m) : position_(vert_index_bound(m)) {}

  /// Calls on_vert(v, index) for each vert and on_edge(e, place_a, place_b, forward) for each edge. The places are the
  /// positions of its two ends in the polygon, counted from 0; forward says whether the polygon goes from the first end
  /// to the second.
  template<class Verts, class Edges, class OnVert, class OnEdge>
  summary walk(const M& m, const Verts& vert_list, const Edges& edge_list, const OnVert& on_vert,
               const OnEdge& on_edge) {
    summary r;
    const std::uint64_t first = next_;
    for (const vert_t<M> v : vert_list) {
      const std::size_t i = index_of(m, v);
      r.repeats = r.repeats || position_[i] >= first;
      position_[i] = next_++;
      ++r.verts;
      on_vert(v, i);
    }
    for (const edge_t<M> e : edge_list) {
      std::uint64_t at[2] = {0, 0};
      int k = 0;
      for (const vert_t<M> v : adj_e2v(m, e))
        if (k < 2) at[k++] = position_[index_of(m, v)];
      if (at[0] < first || at[1] < first) continue;  // no edge of this polygon: a law is broken, see check_laws
      const bool forward = at[1] == at[0] + 1 || (at[1] == first && at[0] + 1 == next_);
      on_edge(e, static_cast<std::uint32_t>(at[0] - first), static_cast<std::uint32_t>(at[1] - first), forward);
    }
    return r;
  }
};

}  // namespace concino::detail
