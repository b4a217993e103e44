// The mean ratio of triangles and tets: how near they are to regular ones.
#pragma once

#include <concino/core/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace concino {

namespace detail {

/// The largest absolute coordinate.
inline double largest_coordinate(const vec3& u) { return std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z)}); }

}  // namespace detail

/// The mean ratio of a triangle: 4 sqrt(3) area / (sum of the squared lengths of its edges).
/// Needs:  finite points.
/// Result: in [0, 1]: 1 if it is equilateral, 0 if it has no area. It does not depend on scale.      Cost: O(1).      Errors: none.
/// Source: Bank and Smith 1997, "Mesh smoothing using a posteriori error estimates".
inline double mean_ratio(const vec3& a, const vec3& b, const vec3& c) {
  vec3 u = b - a, v = c - a;
  const double size = std::max(detail::largest_coordinate(u), detail::largest_coordinate(v));
  if (size == 0) return 0;
  u /= size, v /= size;
  const vec3 w = v - u;
  return std::min(1.0, 2 * std::sqrt(3.0) * norm(cross(u, v)) / (dot(u, u) + dot(v, v) + dot(w, w)));
}

/// The mean ratio of a tet: 12 (3 volume)^(2/3) / (sum of the squared lengths of its edges).
/// Needs:  finite points.
/// Result: in [-1, 1]: 1 if it is regular, 0 if it has no volume, negative if it is inverted. It does not depend on scale.      Cost: O(1).      Errors: none.
/// Source: Liu and Joe 1994, "Relationship between tetrahedron shape measures".
inline double mean_ratio(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
  vec3 u = b - a, v = c - a, w = d - a;
  const double size = std::max({detail::largest_coordinate(u), detail::largest_coordinate(v), detail::largest_coordinate(w)});
  if (size == 0) return 0;
  u /= size, v /= size, w /= size;
  const vec3 x = v - u, y = w - v, z = u - w;
  const double half_det = dot(cross(u, v), w) / 2, squares = dot(u, u) + dot(v, v) + dot(w, w) + dot(x, x) + dot(y, y) + dot(z, z);
  const double root = std::cbrt(half_det);
  return std::clamp((root < 0 ? -12 : 12) * root * root / squares, -1.0, 1.0);
}

}  // namespace concino
