// The sides of the faces of a volume: from which vert along which edge, as the face is walked.
#pragma once

#include <concino/concepts/volume_mesh.hpp>
#include <concino/core/flat_array.hpp>

#include <span>

namespace concino::detail {

/// A side of a face, by index.
struct face_side {
  std::uint32_t from;
  std::uint32_t edge : 31;
  std::uint32_t forward : 1;  // from the first end of the edge to the second
};

/// adj_f2v and adj_f2e each come in an order of their own; this brings them together for all faces, in linear time.
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
    std::vector<std::uint32_t> place(vert_index_bound(m));  // of a vert in the face at hand
    for (const face_t<M> f : faces(m)) {
      face_side* const side = sides_.data() + first_[index_of(m, f)];
      std::uint32_t n = 0;
      for (const vert_t<M> v : adj_f2v(m, f)) {
        side[n].from = static_cast<std::uint32_t>(index_of(m, v));
        place[index_of(m, v)] = n++;
      }
      for (const edge_t<M> e : adj_f2e(m, f)) {
        std::size_t ends[2] = {0, 0}, k = 0;
        for (const vert_t<M> v : adj_e2v(m, e))
          if (k < 2) ends[k++] = index_of(m, v);
        second_end_[index_of(m, e)] = static_cast<std::uint32_t>(ends[1]);
        const std::uint32_t a = place[ends[0]], b = place[ends[1]];
        const bool forward = (a + 1 == n ? 0 : a + 1) == b;
        side[forward ? a : b].edge = static_cast<std::uint32_t>(index_of(m, e)) & 0x7fffffffu;
        side[forward ? a : b].forward = forward;
      }
    }
  }

  std::span<const face_side> of(std::size_t face) const { return {sides_.data() + first_[face], sides_.data() + first_[face + 1]}; }
  /// The last of adj_e2v, for edges of some face.
  std::uint32_t second_end(std::size_t edge) const { return second_end_[edge]; }
};

}  // namespace concino::detail
