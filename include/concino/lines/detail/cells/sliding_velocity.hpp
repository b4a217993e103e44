// The velocity of a line along a triangle towards which the fields on both sides push it.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/lines/detail/cells/line_signs.hpp>

#include <algorithm>

namespace concino::detail {

/// The velocity along a triangle, of fields that push towards it from both sides.      Source: Filippov 1988, as
/// sliding_speed.
inline vec3 sliding_velocity(double speed1, const vec3& field1, double speed2, const vec3& field2, const vec3& normal) {
  const double exit_speed = speed1 + speed2, n = dot(normal, normal);
  const vec3 v = exit_speed > 0 ? (speed2 * field1 + speed1 * field2) / exit_speed : (field1 + field2) / 2;
  return n > 0 ? v - dot(v, normal) / n * normal : v;
}

/// How fast a field leaves its cell through a triangle; 0 if it does not.
inline double speed_through(const vec3& field, const vec3& p, const vec3& q, const vec3& r) {
  const double n = norm(cross(q - p, r - p));
  return n > 0 ? std::max(0.0, side_of_line(field, q, r, p).value / n) : 0;
}

}  // namespace concino::detail
