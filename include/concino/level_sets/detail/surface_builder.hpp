// Collects points and polygons for a surface of polygons or of triangles.
#pragma once

#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/mesh/arrays.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// Polygons come in parts: their corners are numbers of points of the same part.
class surface_builder {
  surface_arrays a_;
  std::uint32_t shift_ = 0;
  polygon_triangulator triangulate_;
  std::vector<vec3> corners_;

 public:
  explicit surface_builder(bool triangles) {
    if (triangles) a_.arity = 3;
    else a_.offsets.push_back(0);
  }

  /// Makes room for the first part; others make room as they come.
  void reserve(std::size_t points, std::size_t corners, std::size_t polygons) {
    if (!a_.points.empty()) return;
    a_.points.reserve(points);
    a_.verts.reserve(corners);
    if (a_.arity == 0) a_.offsets.reserve(polygons + 1);
  }
  void add_point(const vec3& x) { a_.points.push_back(x); }

  /// Adds a polygon, or the triangles of its triangulation. Returns how many polys these are.
  std::size_t add_polygon(std::span<const std::uint32_t> corners) {
    if (a_.arity == 0 || corners.size() == 3) {
      for (const std::uint32_t v : corners) a_.verts.push_back(vert_id{shift_ + v});
      if (a_.arity == 0) a_.offsets.push_back(static_cast<std::uint32_t>(a_.verts.size()));
      return 1;
    }
    corners_.clear();
    for (const std::uint32_t v : corners) corners_.push_back(a_.points[shift_ + v]);
    const auto triangles = triangulate_(corners_);
    for (const polygon_triangle& t : triangles)
      for (const std::uint32_t k : t) a_.verts.push_back(vert_id{shift_ + corners[k]});
    return triangles.size();
  }
  void end_part() { shift_ = static_cast<std::uint32_t>(a_.points.size()); }

  surface_arrays arrays() && { return std::move(a_); }
};

}  // namespace concino::detail
