// Where an element lies: the mean of its verts.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/geometry/vec3.hpp>

namespace concino {

/// The mean of the verts of poly p: a point that exists for every poly, degenerate and non-planar ones included, and that is cheap.
/// For the centre of mass see `centroid`.
/// Needs:  Embedded M with adj_p2v.      Result: a point, in units of the mesh.      Cost: O(verts of p).      Errors: none.
template<Embedded M>
  requires requires(const M& m, poly_t<M> p) { adj_p2v(m, p); }
vec3 vert_mean(const M& m, const poly_t<M>& p) {
  vec3 sum;
  double n = 0;
  for (const vert_t<M> v : adj_p2v(m, p)) {
    sum += to_vec3(point(m, v));
    n += 1;
  }
  return n > 0 ? sum / n : sum;
}

}  // namespace concino
