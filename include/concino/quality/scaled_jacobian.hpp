// The scaled Jacobian of triangles and tets: the smallest determinant of edges of unit length at a corner.
#pragma once

#include <concino/quality/metric.hpp>

namespace concino {

/// The scaled Jacobian of a triangle: the smallest sine of its angles, divided by that of 60 degrees.
/// Needs:  nothing.
/// Result: in [0, 1]: 1 if it is equilateral, 0 if it has no area; NaN if a point is not finite. It does not depend on
///         scale.      Cost: O(1).
/// Errors: none.
/// Source: Knupp, Ernst, Thompson, Stimpson and Pebay 2006, "The Verdict geometric quality library".
inline double scaled_jacobian(const vec3& a, const vec3& b, const vec3& c) {
  const vec3 points[] = {a, b, c};
  return quality(poly_shape::triangle, points, metric::scaled_jacobian);
}

/// The scaled Jacobian of a tet: sqrt(2) times the smallest determinant of three edges of unit length at a vert.
/// Needs:  nothing.
/// Result: in [-1, 1]: 1 if it is regular, 0 if it has no volume, negative if it is inverted; NaN if a point is not
///         finite. It does not depend on scale.
/// Cost:   O(1).      Errors: none.
/// Source: as above.
inline double scaled_jacobian(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
  const vec3 points[] = {a, b, c, d};
  return quality(poly_shape::tet, points, metric::scaled_jacobian);
}

}  // namespace concino
