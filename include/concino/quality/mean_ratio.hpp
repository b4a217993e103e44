// The mean ratio of triangles and tets: how near they are to regular ones.
#pragma once

#include <concino/quality/metric.hpp>

namespace concino {

/// The mean ratio of a triangle: 4 sqrt(3) area / (sum of the squared lengths of its edges).
/// Needs:  nothing.
/// Result: in [0, 1]: 1 if it is equilateral, 0 if it has no area; NaN if a point is not finite. It does not depend on
///         scale.      Cost: O(1).
/// Errors: none.
/// Source: Bank and Smith 1997, "Mesh smoothing using a posteriori error estimates".
inline double mean_ratio(const vec3& a, const vec3& b, const vec3& c) {
  const vec3 points[] = {a, b, c};
  return quality(poly_shape::triangle, points, metric::mean_ratio);
}

/// The mean ratio of a tet: 12 (3 volume)^(2/3) / (sum of the squared lengths of its edges). Verdict's tet_mean_ratio
/// is its power 3/2.
/// Needs:  nothing.
/// Result: in [-1, 1]: 1 if it is regular, 0 if it has no volume, negative if it is inverted; NaN if a point is not
///         finite. It does not depend on scale.
/// Cost:   O(1).      Errors: none.
/// Source: Liu and Joe 1994, "Relationship between tetrahedron shape measures".
inline double mean_ratio(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
  const vec3 points[] = {a, b, c, d};
  return quality(poly_shape::tet, points, metric::mean_ratio);
}

}  // namespace concino
