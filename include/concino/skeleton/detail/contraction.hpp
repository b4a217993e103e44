// A closed surface that contracts to a curve.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/skeleton/detail/medial_balls.hpp>
#include <concino/skeleton/detail/triangle_complex.hpp>
#include <concino/solve/ldlt.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// A surface that flows by its mean curvature, while each vert is drawn to the centre of its medial ball and resists
/// the more, the more the area around it has shrunk. All three are measured by the radius of the ball: thin and thick
/// parts contract in the same number of steps. Points have a size near 1.
class contraction {
  using index = std::uint32_t;

  triangle_complex mesh_;
  std::vector<vec3> points_;
  std::vector<medial_ball> balls_;
  std::vector<double> masses_;   // by vert: its part of the first area
  std::vector<char> is_frozen_;  // by vert: whether what is around it is too thin to go on
  std::vector<double> areas_;    // by vert: a third of the area of its triangles
  ldlt solver_;
  double shortest_ = 0;  // edge that remains
  double time_ = 0.5, first_area_ = 0, area_ = 0;

  void measure();
  bool is_short(index a, index b) const { return distance(points_[a], points_[b]) < shortest_; }
  void collapse_short_edges();
  void split_flat_triangles();
  void freeze_thin_parts();

 public:
  contraction(const std::vector<vec3>& points, const std::vector<std::array<index, 3>>& triangles);

  const std::vector<vec3>& points() const { return points_; }
  const std::vector<medial_ball>& balls() const { return balls_; }
  const std::vector<double>& masses() const { return masses_; }
  bool has_area() const { return first_area_ > 0; }
  double relative_area() const { return area_ / first_area_; }
  /// A step of the flow, then collapses and splits of edges.
  void step();
  /// The curve that is left if all triangles are collapsed.
  triangle_complex curve();
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/skeleton/detail/contraction.ipp>
#endif
