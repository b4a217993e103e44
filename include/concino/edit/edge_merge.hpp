// Merges the two edges at a vert into one: the inverse of edge_split in polygons and polyhedra.
#pragma once

#include <concino/edit/detail/facet_flip.hpp>
#include <concino/edit/detail/operator_checks.hpp>
#include <concino/edit/detail/polys/general_checks.hpp>

#include <vector>

namespace concino {

namespace detail {

inline constexpr permission not_two_edges{refusal::wrong_number,
                                          "the vert does not have exactly two edges, with polys"};

/// The polys at v lose it. a, b: the other ends of its edges.
template<class M>
permission edge_merge_cavity(const M& m, const vert_t<M>& v, general_cavity<M>& c, vert_t<M>& a, vert_t<M>& b) {
  unsigned n = 0;
  for (const vert_t<M> x : adj_v2v(m, v)) {
    if (n == 2) return not_two_edges;
    (n++ == 0 ? a : b) = x;
  }
  if (n != 2) return not_two_edges;
  if constexpr (VolumeMesh<M>)  // surfaces have no faces
    if (is_any_loose(m, adj_v2f(m, v))) return loose_face_at_element;
  for (const poly_t<M> p : adj_v2p(m, v)) c.add_old(p);
  if (c.num_old() == 0) return not_two_edges;
  if (are_joined_by_edge(m, a, b)) return general_same_verts;
  const unsigned removed = c.vert(v);
  std::vector<unsigned> list;
  for (unsigned k = 0; k < c.num_old(); ++k) {
    for (std::size_t i = c.old_polys().first_list(k); i < c.old_polys().last_list(k); ++i) {
      list.clear();
      for (const unsigned x : c.old_polys().list(i))
        if (x != removed) list.push_back(x);
      c.add_list(list);
    }
    c.end_new(k);
  }
  c.remove(removed);
  return {};
}

}  // namespace detail

/// Whether the two edges at v can be merged: it has no others, the other ends of these are not joined, no polygon or
/// face has v and two other verts only, and the invariants hold.
/// Needs:  EditableGeneralMesh M, a vert of m.      Result: true, or the reason.
/// Cost:   the polys at v, and those at the other ends.      Errors: as edge_merge.
template<EditableGeneralMesh M>
permission can_edge_merge(const M& m, vert_t<M> v, const edit_options& options = {}) {
  detail::check_element(m, v, "can_edge_merge", "vert");
  detail::general_cavity<M> c(m);
  vert_t<M> a{}, b{};
  if (const permission p = detail::edge_merge_cavity(m, v, c, a, b); !p) return p;
  return detail::allow_general(options.keep, c);
}

/// Removes v, a vert of two edges, which become one: polygons and faces at it lose a corner. Where v is not on the
/// straight line between the other ends, the shape changes.
/// Needs:  EditableGeneralMesh M.
/// Result: the new edge, or the reason why not. Other descriptors remain valid, apart from those of v, of its edges and
///         of the faces at it.
/// Cost:   that of can_edge_merge, and the elements at the verts of the polys at v, but O(mesh) the first time.
/// Errors: invalid_mesh if v is not a vert of m, and what an invariant throws. The mesh is unchanged then, also if
///         memory runs out.
template<EditableGeneralMesh M>
edge_result<M> edge_merge(M& m, vert_t<M> v, const edit_options& options = {}) {
  detail::check_element(m, v, "edge_merge", "vert");
  detail::general_cavity<M> c(m);
  vert_t<M> a{}, b{};
  if (const permission p = detail::edge_merge_cavity(m, v, c, a, b); !p) return {p};
  if (const permission p = detail::allow_general(options.keep, c); !p) return {p};
  typename detail::general_cavity<M>::prepared x;
  c.apply(m, x);
  return {{}, detail::edge_between_verts(m, a, b)};
}

// What to write instead of calls that cannot compile.
template<EditableMesh M, class... T>
  requires(arity_v<M> > 0)
void edge_merge(const M&, const T&...) = delete;  // fixed number of verts: make m a polygonmesh or polyhedralmesh

}  // namespace concino
