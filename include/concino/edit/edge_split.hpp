// Splits an edge of triangles or tets at a point between its ends.
#pragma once

#include <concino/edit/detail/direct_edits.hpp>
#include <concino/edit/detail/propose.hpp>

#include <concino/concepts/end_verts.hpp>
#include <concino/core/number_text.hpp>

namespace concino {

namespace detail {

/// The polys at e, each of which is replaced by two.
template<class M>
permission edge_split_cavity(const M& m, const edge_t<M>& e, double t, cavity_builder<M>& c) {
  const auto ends = end_verts(m, e);
  const unsigned a = c.vert(ends.first), b = c.vert(ends.second), split[] = {b, a};
  for (const poly_t<M> p : adj_e2p(m, e))
    if (!c.add_old(p)) return not_simplices;
  if (has_repeated_polys(c)) return polys_on_same_verts;
  const vec3 first = to_vec3(point(m, ends.first)), second = to_vec3(point(m, ends.second));
  c.add_point(point_between(first, second, t), {a, b, t});
  split_old_polys(c, split, 2);
  return {};
}

inline void check_parameter(double t, const char* edit) {
  if (!(t > 0 && t < 1))
    core::throw_joined<invalid_argument>(
        {edit, ": the parameter is ", core::number_text(t), "; it must be between 0 and 1"});
}

}  // namespace detail

/// Whether e can be split: all polys at it are triangles in a surface, tets in a volume, no two have the same verts,
/// and the invariants hold. Any number of polys is allowed.
/// Needs:  EditableMesh M, an edge of m.      Result: true, or the reason.      Cost: O(polys at e).      Errors: as
///         edge_split.
template<EditableMesh M>
permission can_edge_split(const M& m, edge_t<M> e, double t = 0.5, const edit_options& options = {}) {
  detail::check_element(m, e, "can_edge_split", "edge");
  detail::check_parameter(t, "can_edge_split");
  detail::cavity_builder<M> c(m);
  if (const permission p = detail::edge_split_cavity(m, e, t, c); !p) return p;
  return detail::ask(options.keep, m, c);
}

/// Splits e at (1 - t) a + t b, where a and b are its ends as end_verts lists them, and each poly at it into two.
/// Needs:  EditableMesh M; 0 < t < 1.
/// Result: the new vert, or the reason why not. Of each poly the half at a keeps the descriptor. Other descriptors
///         remain valid, apart from e.
/// Cost:   the elements at the verts of the polys at e, but O(mesh) the first time.
/// Errors: invalid_mesh if e is not an edge of m; invalid_argument if t is not between 0 and 1. The mesh is unchanged
///         then, also if memory runs out.
template<EditableMesh M>
vert_result<M> edge_split(M& m, edge_t<M> e, double t = 0.5, const edit_options& options = {}) {
  detail::check_element(m, e, "edge_split", "edge");
  detail::check_parameter(t, "edge_split");
  if constexpr (detail::splits_edges<M>)
    if (options.keep.empty()) {
      const auto ends = end_verts(m, e);
      const auto made = traits<M>::split_edge(
          m, e, detail::point_between(to_vec3(point(m, ends.first)), to_vec3(point(m, ends.second)), t));
      if (made) return {{}, *made};
    }
  detail::cavity_builder<M> c(m);
  if (const permission p = detail::edge_split_cavity(m, e, t, c); !p) return {p};
  if (const permission p = detail::ask(options.keep, m, c); !p) return {p};
  c.apply(m);
  return {{}, c.new_vert()};
}

}  // namespace concino
