// The scaled Jacobian of triangles and tets: the smallest determinant of edges of unit length at a corner.
#pragma once

#include <concino/core/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace concino {

/// The scaled Jacobian of a triangle: the smallest sine of its angles, divided by that of 60 degrees.
/// Needs:  finite points.
/// Result: in [0, 1]: 1 if it is equilateral, 0 if it has no area. It does not depend on scale.      Cost: O(1).      Errors: none.
/// Source: Knupp, Ernst, Thompson, Stimpson and Pebay 2006, "The Verdict geometric quality library".
inline double scaled_jacobian(const vec3& a, const vec3& b, const vec3& c) {
  vec3 along[] = {b - a, c - b, a - c};
  double length[3], smallest = 2;
  for (unsigned i = 0; i < 3; ++i) {
    length[i] = std::hypot(along[i].x, along[i].y, along[i].z);
    if (length[i] == 0) return 0;
    along[i] /= length[i];
  }
  for (unsigned i = 0; i < 3; ++i) smallest = std::min(smallest, norm(cross(along[i], along[(i + 1) % 3])));
  return std::min(1.0, smallest * 2 / std::sqrt(3.0));
}

/// The scaled Jacobian of a tet: sqrt(2) times the smallest determinant of three edges of unit length at a vert.
/// Needs:  finite points.
/// Result: in [-1, 1]: 1 if it is regular, 0 if it has no volume, negative if it is inverted. It does not depend on scale.      Cost: O(1).      Errors: none.
/// Source: Knupp, Ernst, Thompson, Stimpson and Pebay 2006, "The Verdict geometric quality library".
inline double scaled_jacobian(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
  const std::array<vec3, 4> p{a, b, c, d};
  double smallest = 2, largest = -2;
  for (unsigned i = 0; i < 4; ++i) {
    vec3 e[3];
    unsigned n = 0;
    for (unsigned j = 0; j < 4; ++j) {
      if (j == i) continue;
      vec3 x = p[j] - p[i];
      const double length = std::hypot(x.x, x.y, x.z);
      if (length == 0) return 0;
      e[n++] = x /= length;
    }
    const double det = (i % 2 ? -1 : 1) * dot(cross(e[0], e[1]), e[2]);
    smallest = std::min(smallest, det), largest = std::max(largest, det);
  }
  return std::clamp(std::sqrt(2.0) * (largest < 0 ? largest : smallest), -1.0, 1.0);
}

}  // namespace concino
