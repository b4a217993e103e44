// Splits a face of tets into three, at a point inside, and each tet at it too.
#pragma once

#include <concino/edit/detail/propose.hpp>

namespace concino {

namespace detail {

/// The polys at f, each of which is replaced by three.
template<class M>
permission face_split_cavity(const M& m, const face_t<M>& f, const vec3& x, cavity_builder<M>& c) {
  unsigned split[3], n = 0;
  for (const vert_t<M> v : adj_f2v(m, f)) {
    if (n == 3) return not_simplices;
    split[n++] = c.vert(v);
  }
  for (const poly_t<M> p : adj_f2p(m, f))
    if (!c.add_old(p)) return not_simplices;
  if (has_repeated_polys(c)) return polys_on_same_verts;
  c.add_point(x, {cavity_builder<M>::none, cavity_builder<M>::none, 0});
  split_old_polys(c, split, 3);
  return {};
}

}  // namespace detail

/// Whether f can be split at x: all polys at it are tets, no two have the same verts, and the invariants hold.
/// Needs:  EditableVolumeMesh M, a face of m.      Result: true, or the reason.      Cost: O(polys at f).      Errors:
///         as face_split.
template<EditableVolumeMesh M>
permission can_face_split(const M& m, face_t<M> f, const vec3& x, const edit_options& options = {}) {
  detail::check_element(m, f, "can_face_split", "face");
  detail::check_point(x, "can_face_split");
  detail::cavity_builder<M> c(m);
  if (const permission p = detail::face_split_cavity(m, f, x, c); !p) return p;
  return detail::ask(options.keep, m, c);
}

/// Splits f at x, and each tet at it into three.
/// Needs:  EditableVolumeMesh M; a finite x. If it is not inside f, some of the new tets are degenerate or overlap.
/// Result: the new vert, or the reason why not. Of each tet the part that lacks the first vert of adj_f2v keeps the
///         descriptor. Other descriptors remain valid, apart from f.
/// Cost:   the elements at the verts of the tets, but O(mesh) the first time.
/// Errors: invalid_mesh if f is not a face of m; invalid_argument if x is not finite. The mesh is unchanged then, also
///         if memory runs out.
template<EditableVolumeMesh M>
vert_result<M> face_split(M& m, face_t<M> f, const vec3& x, const edit_options& options = {}) {
  detail::check_element(m, f, "face_split", "face");
  detail::check_point(x, "face_split");
  detail::cavity_builder<M> c(m);
  if (const permission p = detail::face_split_cavity(m, f, x, c); !p) return {p};
  if (const permission p = detail::ask(options.keep, m, c); !p) return {p};
  c.apply(m);
  return {{}, c.new_vert()};
}

}  // namespace concino
