// Bodies of circumsphere.hpp: the centre of the circle through three points or of the sphere through four.
#pragma once

#include <concino/geometry/detail/any_scale.hpp>
#include <concino/geometry/detail/circles/circumsphere.hpp>

namespace concino::detail {

CONCINO_INLINE vec3 centre_of_circumsphere(std::span<const vec3> points) {
  const local_frame frame([&](auto&& visit) {
    for (const vec3& x : points) visit(x);
  });
  const vec3 b = frame(points[1]), c = frame(points[2]);  // the first point is the origin
  if (points.size() == 3) {
    const vec3 n = cross(b, c);
    return frame.from_local((dot(c, c) * cross(n, b) + dot(b, b) * cross(c, n)) / (2 * dot(n, n)));
  }
  const vec3 d = frame(points[3]);
  return frame.from_local((dot(b, b) * cross(c, d) + dot(c, c) * cross(d, b) + dot(d, d) * cross(b, c)) /
                          (2 * dot(b, cross(c, d))));
}

}  // namespace concino::detail
