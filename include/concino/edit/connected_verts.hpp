// Whether verts have an edge or a triangle in common, which edits must not make a second time.
#pragma once

#include <concino/concepts/mesh.hpp>

namespace concino {

namespace detail {

/// Whether three verts have a common face of three verts, which is then `f`.
template<class M>
bool find_face(const M& m, const vert_t<M>& a, const vert_t<M>& b, const vert_t<M>& c, face_t<M>& f) {
  for (const face_t<M> x : adj_v2f(m, a)) {
    unsigned found = 0, other = 0;
    for (const vert_t<M> v : adj_f2v(m, x)) ++(v == a || v == b || v == c ? found : other);
    if (found == 3 && other == 0) return f = x, true;
  }
  return false;
}

}  // namespace detail

/// Whether an edge joins verts a and b.
/// Needs:  AnyMesh, verts of m.      Result: false if they are the same.      Cost: the edges at a.      Errors: none.
template<AnyMesh M>
bool are_joined(const M& m, const vert_t<M>& a, const vert_t<M>& b) {
  for (const vert_t<M> v : adj_v2v(m, a))
    if (v == b) return true;
  return false;
}

/// Whether a triangle joins verts a, b and c.
/// Needs:  VolumeMesh, three verts of m.      Result: whether a face has these verts and no others.      Cost: the
///         faces at a.      Errors: none.
template<VolumeMesh M>
bool are_joined(const M& m, const vert_t<M>& a, const vert_t<M>& b, const vert_t<M>& c) {
  face_t<M> found;
  return detail::find_face(m, a, b, c, found);
}

}  // namespace concino
