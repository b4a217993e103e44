// A table of the oriented edges of all faces of a volume.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/core/flat_array.hpp>

#include <span>

namespace concino::detail {

/// An oriented edge of a face, as indices of its edge and its first vert.
struct indexed_oriented_edge {
  std::uint32_t from;
  std::uint32_t edge : 31;
  std::uint32_t forward : 1;  // its direction is from the first end of the edge to the second
};

/// The oriented edges of all faces, in one array.
template<VolumeMesh M>
class oriented_edge_table {
  std::vector<std::uint32_t> first_;      // by face
  std::vector<std::uint32_t> second_end_;  // by edge
  core::flat_array<indexed_oriented_edge> edges_;

 public:
  explicit oriented_edge_table(const M& m) : first_(face_index_bound(m) + 1), second_end_(edge_index_bound(m)) {
    for (const face_t<M> f : faces(m))
      for ([[maybe_unused]] const vert_t<M> v : adj_f2v(m, f)) ++first_[index_of(m, f) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    edges_.resize(first_.back());
    for (const face_t<M> f : faces(m)) {
      indexed_oriented_edge* const out = edges_.data() + first_[index_of(m, f)];
      std::uint32_t n = 0;
      for (const auto& [e, from, to] : oriented_edges(m, f)) {
        const vert_t<M> second = end_verts(m, e).second;
        second_end_[index_of(m, e)] = static_cast<std::uint32_t>(index_of(m, second));
        out[n].from = static_cast<std::uint32_t>(index_of(m, from));
        out[n].edge = static_cast<std::uint32_t>(index_of(m, e)) & 0x7fffffffu;
        out[n++].forward = second == to;
      }
    }
  }

  std::span<const indexed_oriented_edge> of(std::size_t face) const {
    return {edges_.data() + first_[face], edges_.data() + first_[face + 1]};
  }
  /// The last vert of adj_e2v, for an edge that belongs to a face.
  std::uint32_t second_end(std::size_t edge) const { return second_end_[edge]; }
};

}  // namespace concino::detail
