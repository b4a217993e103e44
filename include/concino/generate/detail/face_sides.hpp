// The sides of the faces of a volume: from which vert along which edge, as the face is walked.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/core/flat_array.hpp>

#include <span>

namespace concino::detail {

/// A side of a face, by index.
struct face_side {
  std::uint32_t from;
  std::uint32_t edge : 31;
  std::uint32_t forward : 1;  // from the first end of the edge to the second
};

/// The sides of all faces in one list.
template<VolumeMesh M>
class face_sides {
  std::vector<std::uint32_t> first_;      // by face
  std::vector<std::uint32_t> second_end_;  // by edge
  core::flat_array<face_side> sides_;

 public:
  explicit face_sides(const M& m) : first_(face_index_bound(m) + 1), second_end_(edge_index_bound(m)) {
    for (const face_t<M> f : faces(m))
      for ([[maybe_unused]] const vert_t<M> v : adj_f2v(m, f)) ++first_[index_of(m, f) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    sides_.resize(first_.back());
    for (const face_t<M> f : faces(m)) {
      face_side* const side = sides_.data() + first_[index_of(m, f)];
      std::uint32_t n = 0;
      for (const auto& [e, from, to] : oriented_edges(m, f)) {
        const vert_t<M> second = end_verts(m, e).second;
        second_end_[index_of(m, e)] = static_cast<std::uint32_t>(index_of(m, second));
        side[n].from = static_cast<std::uint32_t>(index_of(m, from));
        side[n].edge = static_cast<std::uint32_t>(index_of(m, e)) & 0x7fffffffu;
        side[n++].forward = second == to;
      }
    }
  }

  std::span<const face_side> of(std::size_t face) const { return {sides_.data() + first_[face], sides_.data() + first_[face + 1]}; }
  /// The last of adj_e2v, for edges of some face.
  std::uint32_t second_end(std::size_t edge) const { return second_end_[edge]; }
};

}  // namespace concino::detail
