// loose_lists: the lists of verts that are not packed, for changes in place, which need no memory; see incident_lists.hpp.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/mesh/detail/row_places.hpp>
#include <concino/mesh/detail/short_rows.hpp>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>

namespace concino::detail {

/// It has the addresses of the arrays of incident_lists, which compilers would otherwise read again after each change: the fewer instructions an edit has, the
/// sooner the processor requests what the next edit reads. They are valid until memory is allocated.
template<bool WithPolys>
class loose_lists {
  typename row_places<WithPolys>::loose_row* rows_;
  vert_id* verts_;
  edge_id* edges_;
  poly_id* polys_;
  std::size_t size_;  // of each array

  auto& row(vert_id v) const { return rows_[v.raw()]; }

 public:
  loose_lists(typename row_places<WithPolys>::loose_row* rows, vert_id* verts, edge_id* edges, poly_id* polys, std::size_t size)
      : rows_(rows), verts_(verts), edges_(edges), polys_(polys), size_(size) {}

  std::uint32_t num_edges(vert_id v) const { return row(v).last - row(v).first; }
  std::uint32_t position(vert_id v, edge_id e) const { return position_in_row(edges_ + row(v).first, size_ - row(v).first, e); }
  std::uint32_t position(vert_id v, poly_id p) const { return position_in_row(polys_ + row(v).first, size_ - row(v).first, p); }
  std::uint32_t find(vert_id v, vert_id other) const { return find_in_short_row(verts_ + row(v).first, num_edges(v), size_ - row(v).first, other); }

  /// Whether one more edge and one more poly of v need no memory.
  bool has_room(vert_id v) const { return std::max(row(v).last, row(v).second_last) - row(v).first < row(v).room; }
  void push(vert_id v, vert_id other, edge_id e) const {
    assert(num_edges(v) < row(v).room);
    const std::uint32_t at = row(v).last++;
    verts_[at] = other, edges_[at] = e;
  }
  void push(vert_id v, poly_id p) const {
    assert(row(v).second_last - row(v).first < row(v).room);
    polys_[row(v).second_last++] = p;
  }
  /// Removes the k-th edge of v; the last one takes its place.
  void replace_by_last_at(vert_id v, std::uint32_t k) const {
    assert(k < num_edges(v));
    const std::uint32_t at = row(v).first + k, last = --row(v).last;
    verts_[at] = verts_[last], edges_[at] = edges_[last];
  }
  /// Removes the k-th poly of v; the others keep their order.
  [[gnu::always_inline]] inline void remove_poly_at(vert_id v, std::uint32_t k) const {
    const std::uint32_t first = row(v).first, n = row(v).second_last-- - first;
    assert(k < n);
    close_gap_in_row(polys_ + first, k, n, size_ - first);
  }
};

}  // namespace concino::detail
