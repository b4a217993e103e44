// Topology of lists of corners: the cycle around several polygons, and whether faces form a sphere.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/edit/detail/polys/poly_lists.hpp>

#include <span>
#include <vector>

namespace concino::detail {

/// An edge of a cyclic list, by its ends.
struct list_edge {
  unsigned low, high, list;
  bool ascends;  // from the lower to the higher end

  bool is_same(const list_edge& x) const { return low == x.low && high == x.high; }
};

/// The edges of these lists, sorted, so that equal ones follow one another.
std::vector<list_edge> sorted_edges(std::span<const std::span<const unsigned>> lists);

/// What keeps several polygons from becoming one, or faces from being the boundary of a poly.
enum class list_fault : unsigned char {
  none,
  winding,      // two run along an edge in the same direction
  not_a_disk,   // they are no disk, or no sphere
  third_list,   // more than two meet at an edge
};

/// Several polygons that are merged into one.
struct merged_cycle {
  std::vector<unsigned> boundary;                        // the corners of the one, in the direction of the others
  std::vector<unsigned> inside;                          // verts that it does not have
  std::vector<std::pair<unsigned, unsigned>> removed;    // edges that it does not have
};

/// Merges polygons that form a disk.
list_fault merge_lists(std::span<const std::span<const unsigned>> lists, merged_cycle& result);

/// Whether faces form a sphere: two run along each edge in opposite directions, they are connected, and their Euler
/// characteristic is 2.
list_fault check_sphere(std::span<const std::span<const unsigned>> lists);

/// Numbers the parts of faces that are connected through edges other than the given ones (sorted pairs, ascending).
/// Result: the number of parts; part[i] is that of face i.
unsigned find_parts(std::span<const std::span<const unsigned>> lists,
                    std::span<const std::pair<unsigned, unsigned>> barriers, std::vector<unsigned>& part);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/edit/detail/polys/list_topology.ipp>
#endif
