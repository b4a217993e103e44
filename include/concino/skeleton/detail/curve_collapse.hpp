// Collapses of edges of a thin surface until it is a curve, and the nodes of the curve.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// A complex of triangles and edges. Edges of triangles are collapsed, the shortest first, whether that pinches the
/// surface or not: what goes around a thin part vanishes, and what is left when there are no triangles is a curve.
class curve_collapse {
  using index = std::uint32_t;
  using triangle = std::array<index, 3>;

  std::vector<vec3> points_;
  std::vector<double> weights_;
  std::vector<std::vector<index>> neighbours_;              // sorted
  std::vector<std::vector<std::array<index, 2>>> opposite_;  // sorted: the other two verts of the triangles
  std::vector<index> joined_to_;

  bool has_triangle(index a, index b) const;
  void collapse(index a, index b);

 public:
  curve_collapse(std::vector<vec3> points, std::vector<double> weights, const std::vector<triangle>& triangles);
  void run();

  std::size_t num_verts() const { return points_.size(); }
  /// The vert that stands for v after the collapses.
  index representative(index v) const {
    while (joined_to_[v] != v) v = joined_to_[v];
    return v;
  }
  const std::vector<index>& neighbours(index v) const { return neighbours_[v]; }
};

/// Nodes of a curve: groups of verts of the surface.
class curve_nodes {
  using index = std::uint32_t;

  const std::vector<vec3>& at_;
  const std::vector<double>& weights_;
  std::vector<std::vector<index>> from_, neighbours_;
  std::vector<vec3> points_;
  std::vector<double> radii_;

  void measure(index node);
  void join(index a, index b);

 public:
  struct graph_arrays {
    std::vector<vec3> points;
    std::vector<double> radii;
    std::vector<std::array<vert_id, 2>> edges;
    std::vector<std::vector<std::uint32_t>> from;
  };

  /// at: the points before the flow.
  curve_nodes(const curve_collapse& collapse, const std::vector<vec3>& at, const std::vector<double>& weights);
  /// Joins bones that end at a leaf within the radius of their joint to it.
  void join_short_bones();
  graph_arrays result() const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/skeleton/detail/curve_collapse.ipp>
#endif
