// A polygon in space, projected to the plane along its vector area. For functions that are defined in a plane.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/detail/any_scale.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace concino::core {

/// Two edges of a polygon, by their first corners.
using two_edges = std::array<std::size_t, 2>;

/// The projection of a polygon along its vector area, at a size near 1; corners are counter-clockwise in x and y, and
/// have z = 0. The plane goes through the mean of the corners.
class flat_polygon {
  detail::local_frame frame_;
  std::vector<vec3> corners_;
  vec3 u_ = {1, 0, 0}, v_ = {0, 1, 0}, normal_;
  double height_ = 0, area_ = 0;

 public:
  explicit flat_polygon(std::span<const vec3> points);

  const std::vector<vec3>& corners() const { return corners_; }
  /// Whether all points are finite.
  bool is_finite() const { return frame_.is_finite(); }
  /// The area of the projection, at the size of corners(); 0 if it is only rounding errors.
  double area() const { return area_; }
  /// The direction from which the corners are counter-clockwise, of length 1; 0 if there is no area.
  const vec3& normal() const { return normal_; }

  vec3 to_space(const vec3& x) const { return frame_.from_local(x.x * u_ + x.y * v_ + height_ * normal_); }
  vec3 direction_in_space(const vec3& x) const { return x.x * u_ + x.y * v_; }
  /// The original value of a length (dimension 1) or an area (dimension 2).
  double to_space(double size, int dimension) const { return frame_.from_local(size, dimension); }

  /// Two edges that cross or touch, other than at a corner that they share, or an edge without length, twice.
  std::optional<two_edges> find_touching_edges() const;
};

/// Errors: invalid_argument that begins with `who` if there are fewer than three points, one is not finite, or there is
///         no area, or if two edges touch.
flat_polygon checked_simple_polygon(std::span<const vec3> points, const char* who);

/// The same, of poly number `poly` of a mesh.
/// Errors: invalid_mesh.
flat_polygon checked_simple_polygon(std::span<const vec3> points, const char* who, std::size_t poly);

}  // namespace concino::core

#ifndef CONCINO_COMPILED
#include <concino/geometry/detail/flat_polygon.ipp>
#endif
