// The point of a segment or a triangle that is nearest to another point.
#pragma once

#include <concino/core/vec3.hpp>

namespace concino {

/// The point nearest to x of the segment from a to b.
/// Needs:  finite points whose squared distances neither overflow nor underflow.
/// Result: a point; exactly a or b where one of them is nearest, and a where both are the same point.      Cost: O(1).      Errors: none.
inline vec3 closest_point(const vec3& x, const vec3& a, const vec3& b) {
  const vec3 ab = b - a;
  const double along = dot(x - a, ab), whole = dot(ab, ab);
  if (!(along > 0)) return a;
  if (along >= whole) return b;
  return a + (along / whole) * ab;
}

/// The point nearest to x of the triangle a, b, c.
/// Needs:  finite points; products of four of their distances neither overflow nor underflow.
/// Result: a point; exactly a corner where one is nearest. The error grows with the aspect ratio of the triangle, not with its square, as it does
///         where barycentric coordinates are had from dot products of edges. A triangle without area is the longest of its edges.
/// Cost:   O(1).      Errors: none.
/// Source: Heidrich 2005, "Computing the barycentric coordinates of a projected point"; outside, the edges that x is beyond.
inline vec3 closest_point(const vec3& x, const vec3& a, const vec3& b, const vec3& c) {
  const vec3 ab = b - a, bc = c - b, ca = a - c, normal = cross(ab, -ca);
  // the parts that a, b and c have in the projection of x, times the same positive number
  const double u = dot(cross(bc, x - b), normal), v = dot(cross(ca, x - c), normal), w = dot(cross(ab, x - a), normal);
  if (u > 0 && v > 0 && w > 0) return a + (v / (u + v + w)) * ab - (w / (u + v + w)) * ca;
  // the nearest point lies on an edge that x is not inside of; at least one there is, or the triangle has no area and all count
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
