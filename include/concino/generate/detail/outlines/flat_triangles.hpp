// Triangulations of polygons without flat triangles, where corners may be collinear.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/geometry/triangulate_polygon.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// Triangulates polygons as polygon_triangulator, and replaces triangles without area, up to rounding: each is flipped
/// with the triangle beyond its longest edge, if both new ones have area. It costs O(log n) more for each edge of a
/// polygon of n verts that has such triangles.
class polygon_cutter {
  using index = std::uint32_t;

  polygon_triangulator triangulate_;
  std::vector<polygon_triangle> triangles_;
  std::vector<vec3> corners_;  // scaled
  vec3 normal_;
  std::vector<std::size_t> flat_, left_;
  std::map<std::pair<index, index>, std::size_t> triangle_at_;  // by directed edge

  bool set_corners(std::span<const vec3> corners);
  double squared_length(index a, index b) const;
  bool is_flat(const polygon_triangle& t) const;
  void enter(std::size_t t);
  bool flip(std::size_t t);
  void flip_all();

 public:
  std::span<const polygon_triangle> operator()(std::span<const vec3> corners);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/outlines/flat_triangles.ipp>
#endif
