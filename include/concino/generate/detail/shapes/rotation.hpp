// Rotation of points around an axis.
#pragma once

#include <concino/core/vec3.hpp>

#include <cmath>

namespace concino::detail {

/// Rotates points counter-clockwise around an axis of length 1, seen from where it points to.
class rotation {
  vec3 centre_, axis_;
  double tolerance_;

 public:
  /// Points within the distance `tolerance` from the axis are on it.
  rotation(const vec3& centre, const vec3& axis, double tolerance)
      : centre_(centre), axis_(axis), tolerance_(tolerance) {}

  bool is_on_axis(const vec3& x) const { return norm(cross(axis_, x - centre_)) <= tolerance_; }
  vec3 operator()(const vec3& x, double angle) const {
    if (angle == 0 || is_on_axis(x)) return x;
    const vec3 from_centre = x - centre_, along = dot(from_centre, axis_) * axis_;
    return centre_ + along + std::cos(angle) * (from_centre - along) + std::sin(angle) * cross(axis_, from_centre);
  }
};

}  // namespace concino::detail
