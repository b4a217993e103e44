// Triangles that change by collapses and splits of edges, at the end until they are a curve.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// In sorted lists.
template<class T>
void insert_in_order(std::vector<T>& list, const T& x) {
  const auto place = std::lower_bound(list.begin(), list.end(), x);
  if (place == list.end() || !(*place == x)) list.insert(place, x);
}
template<class T>
void erase_in_order(std::vector<T>& list, const T& x) {
  const auto place = std::lower_bound(list.begin(), list.end(), x);
  if (place != list.end() && *place == x) list.erase(place);
}

/// A complex of triangles and edges, and which verts stand for others after collapses. Points are those of its user.
class triangle_complex {
  using index = std::uint32_t;

  std::vector<std::vector<index>> neighbours_;               // sorted
  std::vector<std::vector<std::array<index, 2>>> opposite_;  // sorted: the other two verts of the triangles
  std::vector<index> joined_to_;

  bool has_triangle(index a, index b) const;

 public:
  triangle_complex(std::size_t num_verts, const std::vector<std::array<index, 3>>& triangles);

  std::size_t num_verts() const { return joined_to_.size(); }
  bool is_alive(index v) const { return joined_to_[v] == v; }
  /// The vert that stands for v after the collapses.
  index representative(index v) const {
    while (joined_to_[v] != v) v = joined_to_[v];
    return v;
  }
  const std::vector<index>& neighbours(index v) const { return neighbours_[v]; }
  const std::vector<std::array<index, 2>>& opposite(index v) const { return opposite_[v]; }
  std::vector<std::array<index, 3>> triangles() const;

  /// Whether a closed surface is still one, of the same genus, after the collapse of an edge: the link condition.
  bool is_collapsible(index a, index b) const;
  /// Joins a to b.
  void collapse(index a, index b);
  /// Splits the edge and its triangles by a new vert, whose number is the result.
  index split(index a, index b);
  /// Collapses edges of triangles, the shortest first, whether that pinches the surface or not: what goes around a thin
  /// part vanishes, and what is left when there are no triangles is a curve. A vert that is left is at the mean of what
  /// it stands for, by weight.
  void collapse_to_curve(std::vector<vec3>& points, std::vector<double>& weights);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/skeleton/detail/triangle_complex.ipp>
#endif
