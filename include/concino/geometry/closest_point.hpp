// The closest point of a segment or a triangle to another point.
#pragma once

#include <concino/core/vec3.hpp>

namespace concino {

/// The point of the segment from a to b nearest to x.
/// Needs:  finite points whose squared distances neither overflow nor underflow.
/// Result: a point; exactly a or b if one of them is nearest, and a if both are equal.      Cost: O(1).      Errors:
///         none.
inline vec3 closest_point(const vec3& x, const vec3& a, const vec3& b) {
  const vec3 ab = b - a;
  const double along = dot(x - a, ab), whole = dot(ab, ab);
  if (!(along > 0)) return a;
  if (along >= whole) return b;
  return a + (along / whole) * ab;
}

/// The point of the triangle a, b, c nearest to x.
/// Needs:  finite points; products of four of their distances neither overflow nor underflow.
/// Result: a point; exactly a corner if one is nearest. The error grows with the aspect ratio of the triangle, not with
///         its square, as it does for barycentric coordinates from dot products of edges. A triangle without area is
///         treated as its longest edge.
/// Cost:   O(1).      Errors: none.
/// Source: Heidrich 2005, "Computing the barycentric coordinates of a projected point"; if the projection is outside,
///         the edges that separate it.
inline vec3 closest_point(const vec3& x, const vec3& a, const vec3& b, const vec3& c) {
  const vec3 ab = b - a, bc = c - b, ca = a - c, normal = cross(ab, -ca);
  // barycentric coordinates of the projection of x, times the same positive number
  const double u = dot(cross(bc, x - b), normal), v = dot(cross(ca, x - c), normal), w = dot(cross(ab, x - a), normal);
  if (u > 0 && v > 0 && w > 0) return a + (v / (u + v + w)) * ab - (w / (u + v + w)) * ca;
  // the nearest point lies on an edge with x on its outer side; there is at least one, or the triangle has no area and
  // all edges count
  vec3 best = a;
  double least = dot(x - a, x - a);
  const auto edge = [&](const vec3& p, const vec3& q) {
    const vec3 y = closest_point(x, p, q);
    const double squared = dot(x - y, x - y);
    if (squared < least) {
      least = squared;
      best = y;
    }
  };
  if (!(w > 0)) edge(a, b);
  if (!(u > 0)) edge(b, c);
  if (!(v > 0)) edge(c, a);
  return best;
}

}  // namespace concino
