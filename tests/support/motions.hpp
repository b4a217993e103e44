// Rotates, translates and scales the arrays of a mesh.
#pragma once

#include <concino/core/vec3.hpp>

#include <cmath>
#include <type_traits>

namespace concino::testing {

/// x rotated by 0.7 radians about the axis (1, 2, 3).
inline vec3 rotated(const vec3& x) {
  const vec3 axis = vec3{1, 2, 3} / std::sqrt(14.0);
  const double c = std::cos(0.7), s = std::sin(0.7);
  return c * x + s * cross(axis, x) + (1 - c) * dot(axis, x) * axis;
}

template<class Arrays>
  requires requires(Arrays a) { a.points; }
Arrays rotated(Arrays a) {
  for (vec3& x : a.points) x = rotated(x) + vec3{10, -20, 30};
  return a;
}

/// Scales the points. Factors that are powers of two are exact.
template<class Arrays>
  requires requires(Arrays a) { a.points; }
Arrays scaled(Arrays a, double factor) {
  for (vec3& x : a.points) x *= factor;
  return a;
}

}  // namespace concino::testing
