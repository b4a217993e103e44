// Splits a triangle into three or a tet into four, at a point inside.
#pragma once

#include <concino/edit/detail/propose.hpp>

namespace concino {

namespace detail {

/// The poly p, which is replaced by one poly for each of its facets.
template<class M>
permission poly_split_cavity(const poly_t<M>& p, const vec3& x, cavity_builder<M>& c) {
  if (!c.add_old(p)) return not_simplices;
  c.add_point(x, {cavity_builder<M>::none, cavity_builder<M>::none, 0});
  split_old_polys(c, c.corners(0), c.size);
  return {};
}

template<class M>
vec3 mean_of_verts(const M& m, const poly_t<M>& p) {
  vec3 sum;
  double n = 0;
  for (const vert_t<M> v : adj_p2v(m, p)) sum += to_vec3(point(m, v)), ++n;
  return sum / n;
}

}  // namespace detail

/// Whether p can be split at x: it is a triangle or a tet, and the invariants hold.
/// Needs:  EditableMesh M, a poly of m.      Result: true, or the reason.      Cost: O(1).      Errors: as poly_split.
template<EditableMesh M>
permission can_poly_split(const M& m, poly_t<M> p, const vec3& x, const edit_options& options = {}) {
  detail::check_element(m, p, "can_poly_split", "poly");
  detail::check_point(x, "can_poly_split");
  detail::cavity_builder<M> c(m);
  if (const permission allowed = detail::poly_split_cavity(p, x, c); !allowed) return allowed;
  return detail::ask(options.keep, m, c);
}
template<EditableMesh M>
permission can_poly_split(const M& m, poly_t<M> p) {
  detail::check_element(m, p, "can_poly_split", "poly");
  return can_poly_split(m, p, detail::mean_of_verts(m, p));
}

/// Splits p at x into one poly for each of its facets.
/// Needs:  EditableMesh M; a finite x. If it is not inside p, some of the new polys overlap.
/// Result: the new vert, or the reason why not. The poly that lacks the first vert of adj_p2v has the descriptor of p.
///         All other descriptors remain valid.
/// Cost:   the elements at the verts of p, but O(mesh) the first time.
/// Errors: invalid_mesh if p is not a poly of m; invalid_argument if x is not finite. The mesh is unchanged then, also
///         if memory runs out.
template<EditableMesh M>
vert_result<M> poly_split(M& m, poly_t<M> p, const vec3& x, const edit_options& options = {}) {
  detail::check_element(m, p, "poly_split", "poly");
  detail::check_point(x, "poly_split");
  detail::cavity_builder<M> c(m);
  if (const permission allowed = detail::poly_split_cavity(p, x, c); !allowed) return {allowed};
  if (const permission allowed = detail::ask(options.keep, m, c); !allowed) return {allowed};
  c.apply(m);
  return {{}, c.new_vert()};
}

/// Splits p at the mean of its verts.
/// Needs:  EditableMesh M.      Result: as above.      Cost: as above.      Errors: invalid_mesh if p is not a poly of
///         m.
template<EditableMesh M>
vert_result<M> poly_split(M& m, poly_t<M> p) {
  detail::check_element(m, p, "poly_split", "poly");
  return poly_split(m, p, detail::mean_of_verts(m, p));
}

}  // namespace concino
