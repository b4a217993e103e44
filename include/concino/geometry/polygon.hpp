// The mean point and the vector area of a closed polygon of verts. Used for polys of surfaces and faces of volumes.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/vec3.hpp>

namespace concino {

/// The mean of the verts of a polygon and its vector area: the integral of the normal over any surface that it bounds.
/// Its length is the area if the polygon is planar. It points to the side from which the verts are counter-clockwise.
struct polygon_shape {
  vec3 mean;
  vec3 area;
};

namespace detail {

/// at(v): the point of vert v.
template<class V, class Loop, class At>
inline polygon_shape shape_through(const Loop& loop, const At& at) {
  vec3 first, previous, sum, doubled;
  double n = 0;
  for (const V v : loop) {
    const vec3 x = at(v);
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

template<class V, class Loop, class At>
inline vec3 area_vector_through(const Loop& loop, const At& at) {
  auto it = loop.begin();
  const auto end = loop.end();
  vec3 doubled;
  if (!(it != end)) return doubled;
  const auto here = [&] {
    const V v = *it;
    return at(v);
  };
  const vec3 first = here();
  ++it;
  if (!(it != end)) return doubled;
  vec3 previous = here() - first;
  for (++it; it != end; ++it) {
    const vec3 step = here() - first;
    doubled += cross(previous, step);
    previous = step;
  }
  return 0.5 * doubled;
}

/// The points of m, as a function of verts.
template<class M>
auto points_by_vert(const M& m) {
  return [&m](const vert_t<M>& v) { return to_vec3(point(m, v)); };
}

}  // namespace detail

/// The shape of the polygon through `loop`, a range of verts in cyclic order.
/// Needs:  Embedded M.
/// Result: see polygon_shape. Differences to the first vert are summed, so that a polygon far from the origin loses no
///         digits; the same polygon gives the same bits wherever it is used. No area if there are fewer than three
///         verts, or if all are collinear.
/// Cost:   O(verts).      Errors: none.
template<Embedded M, class Loop>
polygon_shape shape_of(const M& m, const Loop& loop) {
  return detail::shape_through<vert_t<M>>(loop, detail::points_by_vert(m));
}

/// The vector area only.
/// Needs:  Embedded M.      Result: the area of shape_of, with the same bits.      Cost: O(verts), half of that of
///         shape_of.      Errors: none.
template<Embedded M, class Loop>  // g++ would not inline it into face_normals, which takes a fifth more time
inline vec3 area_vector_of(const M& m, const Loop& loop) {
  return detail::area_vector_through<vert_t<M>>(loop, detail::points_by_vert(m));
}

}  // namespace concino
