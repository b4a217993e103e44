// Planarity of faces, and the part of a polygon or polyhedron from which all of it is visible: its kernel.
#pragma once

#include <concino/core/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace concino::detail {

struct poly_geometry;  // of metric_row.hpp, which includes the definitions of what is declared here

/// 1 - thickness / (twice the largest distance of a vert from their mean); 0 for a loop without vector area.
template<class PointOf>
double planarity_of_loop(std::size_t n, const PointOf& at) {
  vec3 sum, doubled;
  for (std::size_t i = 0; i < n; ++i) sum += at(i) - at(0);
  for (std::size_t i = 1; i + 1 < n; ++i) doubled += cross(at(i) - at(0), at(i + 1) - at(0));
  const vec3 mean = sum / static_cast<double>(n);
  const double length = norm(doubled);
  if (length == 0) return 0;
  double low = 0, high = 0, largest = 0;  // some verts are on each side of the mean
  for (std::size_t i = 0; i < n; ++i) {
    const vec3 x = at(i) - at(0) - mean;
    const double height = dot(x, doubled) / length;
    low = std::min(low, height), high = std::max(high, height), largest = std::max(largest, norm(x));
  }
  return std::clamp(1 - (high - low) / (2 * largest), 0.0, 1.0);
}

/// The area of the kernel of a polygon, projected along its vector area, as a part of its own; 0 if it has no area.
double kernel_fraction_of_polygon(std::span<const vec3> points, const vec3& area);

/// The volume of the kernel of a polyhedron as a part of its own; 0 if that is not positive. Each face is a fan of
/// triangles about the mean of its verts.
double kernel_fraction_of_polyhedron(const poly_geometry& g, double volume);

}  // namespace concino::detail
