// The nodes of a curve to which a surface was collapsed.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/skeleton/detail/medial_balls.hpp>
#include <concino/skeleton/detail/triangle_complex.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Nodes of a curve: groups of verts of the surface.
class curve_nodes {
  using index = std::uint32_t;

  const std::vector<vec3>& at_;
  const std::vector<double>& weights_;
  const std::vector<medial_ball>& balls_;
  std::vector<std::vector<index>> from_, neighbours_;
  std::vector<vec3> points_;
  std::vector<char> is_joined_;  // by node: whether it became a part of another

  /// The mean of value(v) over the verts of a node, by their weights.
  template<class F>
  double mean(index node, const F& value) const {
    double total = 0, sum = 0;
    for (const index v : from_[node]) {
      total += weights_[v];
      sum += weights_[v] * value(v);
    }
    return total > 0 ? sum / total : 0;
  }
  void join(index a, index b);

 public:
  struct graph_arrays {
    std::vector<vec3> points;
    std::vector<double> radii;
    std::vector<std::array<vert_id, 2>> edges;
    std::vector<std::vector<std::uint32_t>> from;
  };

  /// contracted: the points of the verts of the curve. The others are of the verts of the surface, which come first;
  /// new verts are joined to those.
  curve_nodes(const triangle_complex& curve, const std::vector<vec3>& contracted, const std::vector<vec3>& at,
              const std::vector<double>& weights, const std::vector<medial_ball>& balls);
  /// Joins bones that end at a leaf to their joint, if they are shorter than 1.5 radii of the medial balls there.
  void join_short_bones();
  graph_arrays result() const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/skeleton/detail/curve_nodes.ipp>
#endif
