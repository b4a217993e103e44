// Decides whether the volume of a cell is negative, beyond rounding errors and whatever the magnitude of its
// coordinates.
#pragma once

#include <concino/core/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace concino::detail {

/// The volume between a face and the origin, from its edges.
class volume_under_face {
  vec3 middle_, doubled_area_;

 public:
  void add_edge(const vec3& a, const vec3& b) {
    middle_ += b;
    doubled_area_ += cross(a, b);
  }
  /// Six times the signed volume after n edges. The sum over the triangles is the dot product of the mean point and the
  /// vector area of the face.
  double six_times(std::size_t n) const { return dot(middle_, doubled_area_) / static_cast<double>(n); }
};

}  // namespace concino::detail

namespace concino {

/// Whether products of three such coordinates do not overflow, and what underflows in them is negligible beside 1e-100.
/// Needs:  nothing.                          Result: true if they are; of not a number, false.
/// Cost:   O(1).                             Errors: none.
inline bool has_moderate_coordinates(const vec3& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < 1e100; }

/// The box of the points of a cell, which bounds the rounding errors of its volume. Volumes that are zero but for
/// rounding have no sign, so that a cell without volume is not turned over again each time it is read.
class volume_box {
  vec3 low_, high_;
  bool empty_ = true;

  static bool is_moderate(double extent) { return extent == 0 || (extent > 1e-70 && extent < 1e70); }
  static int exponent_of(double low, double high) {
    const double largest = std::max(std::abs(low), std::abs(high));
    return largest > 0 ? std::ilogb(largest) : 0;
  }

 public:
  void add(const vec3& p) {
    if (empty_) low_ = high_ = p;
    empty_ = false;
    for (std::size_t i = 0; i < 3; ++i) {
      low_[i] = std::min(low_[i], p[i]);
      high_[i] = std::max(high_[i], p[i]);
    }
  }

  /// Whether products of three lengths neither overflow nor underflow. If they do, the volume of the scaled points has
  /// the same sign.
  bool is_moderate() const {
    return is_moderate(high_.x - low_.x) && is_moderate(high_.y - low_.y) && is_moderate(high_.z - low_.z);
  }

  vec3 center() const { return {low_.x / 2 + high_.x / 2, low_.y / 2 + high_.y / 2, low_.z / 2 + high_.z / 2}; }

  /// A point with each coordinate divided by a power of two that is as large as the largest one of the box.
  vec3 scaled(const vec3& p) const {
    return {std::ldexp(p.x, -exponent_of(low_.x, high_.x)), std::ldexp(p.y, -exponent_of(low_.y, high_.y)),
            std::ldexp(p.z, -exponent_of(low_.z, high_.z))};
  }

  /// A bound of the rounding error of six times the volume of a cell whose faces have so many corners; of the scaled
  /// points if not is_moderate().
  double error(std::size_t num_corners) const {
    const vec3 size = is_moderate() ? high_ - low_ : scaled(high_) - scaled(low_);
    return 5e-16 * static_cast<double>(num_corners + 4) * size.x * size.y * size.z;
  }
};

}  // namespace concino
