// The verts, edges and faces of a volume that improvement keeps: those of its boundary and between polys of different
// labels.
#pragma once

#include <concino/concepts/facets.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// None of them ever vanishes while their faces are kept, so their indices remain theirs; elements that are made later
/// are free.
template<class M>
class fixed_elements {
  std::vector<std::uint8_t> verts_, edges_, faces_;  // by index

  static bool has(const std::vector<std::uint8_t>& flags, std::size_t i) { return i < flags.size() && flags[i]; }

 public:
  /// label(p): anything with ==.
  template<class F>
  fixed_elements(const M& m, const F& label)
      : verts_(vert_index_bound(m)), edges_(edge_index_bound(m)), faces_(face_index_bound(m)) {
    for (const face_t<M> f : faces(m)) {
      poly_t<M> at[2];
      unsigned n = 0;
      for (const poly_t<M> p : adj_f2p(m, f)) {
        if (n < 2) at[n] = p;
        ++n;
      }
      if (n == 2 && label(at[0]) == label(at[1])) continue;
      faces_[index_of(m, f)] = 1;
      for (const vert_t<M> v : adj_f2v(m, f)) verts_[index_of(m, v)] = 1;
      for (const edge_t<M> e : adj_f2e(m, f)) edges_[index_of(m, e)] = 1;
    }
  }

  bool has(const M& m, const vert_t<M>& v) const { return has(verts_, index_of(m, v)); }
  bool has(const M& m, const edge_t<M>& e) const { return has(edges_, index_of(m, e)); }
  bool has(const M& m, const face_t<M>& f) const { return has(faces_, index_of(m, f)); }
};

}  // namespace concino::detail
