// The sides of polygons: which edge runs from which vert to which as its poly is walked.
#pragma once

#include <concino/concepts/surface_mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// adj_p2v and adj_p2e each come in an order of their own; this brings them together, in time linear in the poly.
template<SurfaceMesh M>
class side_walker {
  const M& m_;
  std::vector<vert_t<M>> ring_;
  std::vector<std::uint32_t> place_;  // of a vert in the ring of the poly walked last

 public:
  explicit side_walker(const M& m) : m_(m), place_(vert_index_bound(m)) {}

  /// Reads the verts of p and says how many they are.
  std::size_t read(const poly_t<M>& p) {
    ring_.clear();
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      place_[index_of(m_, v)] = static_cast<std::uint32_t>(ring_.size());
      ring_.push_back(v);
    }
    return ring_.size();
  }
  const std::vector<vert_t<M>>& ring() const { return ring_; }

  /// Calls visit(edge, i, j) for every edge of p, the poly read last: p walks it from ring()[i] to ring()[j].
  template<class F>
  void for_each_side(const poly_t<M>& p, F&& visit) const {
    for (const edge_t<M> e : adj_p2e(m_, p)) {
      std::size_t ends[2] = {0, 0}, n = 0;
      for (const vert_t<M> v : adj_e2v(m_, e))
        if (n < 2) ends[n++] = place_[index_of(m_, v)];
      if ((ends[0] + 1) % ring_.size() == ends[1]) visit(e, ends[0], ends[1]);
      else visit(e, ends[1], ends[0]);
    }
  }
};

}  // namespace concino::detail
