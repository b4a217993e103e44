// What one closed polygon of verts says: its mean point and its vector area. Surfaces' polys and volumes' faces are both measured by it.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/geometry/vec3.hpp>

namespace concino {

/// A polygon's mean of verts and its vector area: the integral of the normal over any surface that it bounds, as long as the area
/// where the polygon is planar, and pointing to where the verts run counter-clockwise.
struct polygon_shape {
  vec3 mean;
  vec3 area;
};

/// The shape of the polygon through `loop`, a range of verts in cyclic order.
/// Needs:  Embedded M.
/// Result: see polygon_shape. Differences to the first vert are summed, so that a polygon far from the origin loses no digits; the same
///         polygon gives the same bits wherever it is used. Fewer than three verts, or all on one line: no area.
/// Cost:   O(verts).      Errors: none.
template<Embedded M, class Loop>
polygon_shape shape_of(const M& m, const Loop& loop) {
  vec3 first, previous, sum, doubled;
  double n = 0;
  for (const vert_t<M> v : loop) {
    const vec3 x = to_vec3(point(m, v));
    if (n == 0) {
      first = x;
    } else {
      const vec3 step = x - first;
      sum += step;
      doubled += cross(previous, step);
      previous = step;
    }
    n += 1;
  }
  return {n > 0 ? first + sum / n : first, 0.5 * doubled};
}

/// The vector area alone.
/// Needs:  Embedded M.      Result: the area of shape_of, to the bit.      Cost: O(verts), half of that.      Errors: none.
template<Embedded M, class Loop>
vec3 area_vector_of(const M& m, const Loop& loop) {
  auto it = loop.begin();
  const auto end = loop.end();
  vec3 doubled;
  if (!(it != end)) return doubled;
  const auto at = [&] {
    const vert_t<M> v = *it;
    return to_vec3(point(m, v));
  };
  const vec3 first = at();
  ++it;
  if (!(it != end)) return doubled;
  vec3 previous = at() - first;
  for (++it; it != end; ++it) {
    const vec3 step = at() - first;
    doubled += cross(previous, step);
    previous = step;
  }
  return 0.5 * doubled;
}

}  // namespace concino
