// The edges of lists of polygons: which corners begin at each.
#pragma once

#include <concino/core/compiled.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Corner c, by its position in the lists, begins the edge to the next corner of its poly.
class edge_lists {
  std::vector<std::uint32_t> edge_of_, poly_of_, next_;  // by corner
  std::vector<std::uint32_t> first_{0}, corners_;        // by edge

 public:
  edge_lists() = default;
  edge_lists(const std::vector<std::uint32_t>& poly_offsets, const std::vector<std::uint32_t>& verts,
             std::size_t num_verts);

  std::size_t num_edges() const { return first_.size() - 1; }
  std::uint32_t edge_of(std::size_t corner) const { return edge_of_[corner]; }
  std::uint32_t poly_of(std::size_t corner) const { return poly_of_[corner]; }
  std::uint32_t next(std::size_t corner) const { return next_[corner]; }
  /// The corners that begin edge e, in ascending order.
  std::span<const std::uint32_t> corners(std::size_t e) const {
    return {corners_.data() + first_[e], corners_.data() + first_[e + 1]};
  }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/repair/detail/edge_lists.ipp>
#endif
