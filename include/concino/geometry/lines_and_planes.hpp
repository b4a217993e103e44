// Planes, rays and segments, one type each, for cuts, slices and traced lines.
#pragma once

#include <concino/core/vec3.hpp>

namespace concino {

/// The points x with dot(normal, x) == offset. The normal has any length but 0; it points to the upper side.
struct plane {
  vec3 normal = {0, 0, 1};
  double offset = 0;  // in units of length times the unit of the normal
};

/// A half-line from origin in a direction of any length but 0.
struct ray {
  vec3 origin;
  vec3 direction = {0, 0, 1};
};

/// The straight line between two points.
struct segment {
  vec3 from, to;
};

/// The plane through a point with this normal.
/// Needs:  a normal of any length but 0.      Result: a plane with the normal unchanged.      Cost: O(1).      Errors:
///         none.
inline plane plane_through(const vec3& x, const vec3& normal) { return {normal, dot(normal, x)}; }

/// The distance of x above a plane, negative below it.
/// Needs:  a normal that is not 0.      Result: in units of length; scales exactly by powers of two.      Cost: O(1).  
///            Errors: none.
inline double signed_distance(const plane& p, const vec3& x) { return (dot(p.normal, x) - p.offset) / norm(p.normal); }

/// The point at a parameter: origin + t direction for a ray; for a segment from `from` at 0 to `to` at 1.
/// Needs:  a finite t.      Result: a point; the ends of a segment exactly.      Cost: O(1).      Errors: none.
inline vec3 point_at(const ray& r, double t) { return r.origin + t * r.direction; }
inline vec3 point_at(const segment& s, double t) { return (1 - t) * s.from + t * s.to; }

/// The parameter in [0, 1] of the point of a segment that is closest to x.
/// Needs:  nothing.      Result: 0 if the segment has no length.      Cost: O(1).      Errors: none.
inline double closest_parameter(const segment& s, const vec3& x) {
  const vec3 along = s.to - s.from;
  const double squared = dot(along, along), t = dot(x - s.from, along);
  if (!(t > 0)) return 0;
  return t < squared ? t / squared : 1;
}

}  // namespace concino
