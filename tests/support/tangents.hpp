// Tangent vectors at verts as vectors in space, for surfaces that are flat or smooth near the vert.
#pragma once

#include <concino/concepts/surface_mesh.hpp>
#include <concino/core/tangent_vector.hpp>
#include <concino/core/vec3.hpp>

namespace concino::testing {

/// The direction of the first edge of v, of length 1.
template<class M>
vec3 first_edge(const M& m, const vert_t<M>& v) {
  for (const auto e : adj_v2e(m, v))
    for (const auto w : adj_e2v(m, e))
      if (!(w == v)) return (to_vec3(point(m, w)) - to_vec3(point(m, v))) / distance(to_vec3(point(m, w)), to_vec3(point(m, v)));
  return {};
}

/// The vector t of vert v in space; normal: of the surface, of length 1.
template<class M>
vec3 in_space(const M& m, const vert_t<M>& v, const vec3& normal, const tangent_vector& t) {
  const vec3 edge = first_edge(m, v), flat = edge - dot(edge, normal) * normal, x = flat / norm(flat);
  return t.x * x + t.y * cross(normal, x);
}

}  // namespace concino::testing
