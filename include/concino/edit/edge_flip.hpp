// Flips an edge. Between two triangles (2-2), it is replaced by the edge between the two verts opposite to it. An edge
// with three tets is replaced by a face (3-2), one with four tets by another edge (4-4).
#pragma once

#include <concino/edit/detail/direct_edits.hpp>
#include <concino/edit/detail/edge_ring.hpp>
#include <concino/edit/detail/facet_flip.hpp>

namespace concino {

/// Options of edge_flip for volumes.
struct edge_flip_options {
  std::vector<invariant> keep = {};  // see edit_options
  unsigned diagonal = 0;  // 0 or 1. Of the two edges that may replace one with four tets: 0, the one at the first vert
                          // of the first tet of adj_e2p that is no end of the edge; 1, the other one
};

/// What edge_flip of a volume made: a face if the edge had three tets, an edge if it had four. Only this one is valid.
template<class M>
struct edge_flip_result : permission {
  face_t<M> face{};
  edge_t<M> edge{};
};

namespace detail {

inline void check_diagonal(const edge_flip_options& options, const char* edit) {
  if (options.diagonal > 1)
    core::throw_joined<invalid_argument>({edit, ": options.diagonal is ", options.diagonal, "; it must be 0 or 1"});
}

}  // namespace detail

/// Whether e can be flipped: it has two triangles, which are consistently oriented, and the verts opposite to it are
/// not joined yet. The invariants hold.
/// Needs:  EditableSurfaceMesh M, an edge of m.      Result: true, or the reason.
/// Cost:   the edges at an opposite vert.            Errors: invalid_mesh if e is not an edge of m.
template<EditableSurfaceMesh M>
permission can_edge_flip(const M& m, edge_t<M> e, const edit_options& options = {}) {
  detail::check_element(m, e, "can_edge_flip", "edge");
  return detail::can_flip_facet(m, e, options.keep);
}

/// Replaces e by the edge between the two verts opposite to it.
/// Needs:  EditableSurfaceMesh M.
/// Result: the new edge, or the reason why not. The triangle at the first end of e keeps the descriptor of the first
///         triangle of adj_e2p, the other that of the second. Other descriptors remain valid, apart from e.
/// Cost:   the elements at the verts of the triangles, but O(mesh) the first time.
/// Errors: invalid_mesh if e is not an edge of m. The mesh is unchanged then, also if memory runs out.
template<EditableSurfaceMesh M>
edge_result<M> edge_flip(M& m, edge_t<M> e, const edit_options& options = {}) {
  detail::check_element(m, e, "edge_flip", "edge");
  if constexpr (detail::flips_edges<M>)
    if (options.keep.empty() && traits<M>::flip_edge(m, e)) return {{}, e};
  return detail::flip_facet(m, e, options.keep);
}

/// Whether e can be flipped: it is surrounded by three or four tets, which are consistently oriented, and the new face
/// or edge does not exist yet. The invariants hold.
/// Needs:  EditableVolumeMesh M, an edge of m.
/// Result: true, or the reason. Only no_inversion asks whether the new tets are not inverted.
/// Cost:   the faces at a vert.
/// Errors: invalid_mesh if e is not an edge of m; invalid_argument if options.diagonal is not 0 or 1.
template<EditableVolumeMesh M>
permission can_edge_flip(const M& m, edge_t<M> e, const edge_flip_options& options = {}) {
  detail::check_element(m, e, "can_edge_flip", "edge");
  detail::check_diagonal(options, "can_edge_flip");
  detail::edge_ring<M> r(m);
  if (const permission p = detail::edge_ring_cavity(m, e, options.diagonal, r); !p) return p;
  return detail::ask(options.keep, m, r.cavity);
}

/// Replaces e and its three tets by a face with two, or e and its four tets by another edge with four.
/// Needs:  EditableVolumeMesh M.
/// Result: the new face or edge, or the reason why not. New tets have the descriptors of old ones. Other descriptors
///         remain valid, apart from those of e and its faces.
/// Cost:   the elements at the verts of the tets, but O(mesh) the first time.
/// Errors: invalid_mesh if e is not an edge of m; invalid_argument if options.diagonal is not 0 or 1. The mesh is
///         unchanged then, also if memory runs out.
/// Source: Freitag and Ollivier-Gooch 1997, "Tetrahedral mesh improvement using swapping and smoothing".
template<EditableVolumeMesh M>
edge_flip_result<M> edge_flip(M& m, edge_t<M> e, const edge_flip_options& options = {}) {
  detail::check_element(m, e, "edge_flip", "edge");
  detail::check_diagonal(options, "edge_flip");
  detail::edge_ring<M> r(m);
  if (const permission p = detail::edge_ring_cavity(m, e, options.diagonal, r); !p) return {p};
  if (const permission p = detail::ask(options.keep, m, r.cavity); !p) return {p};
  detail::cavity_builder<M>& c = r.cavity;
  c.apply(m);
  const unsigned d = options.diagonal;
  edge_flip_result<M> made;
  if (c.num_old() == 3)
    detail::find_face(m, c.vert_at(r.ring[0]), c.vert_at(r.ring[1]), c.vert_at(r.ring[2]), made.face);
  else made.edge = detail::edge_between_verts(m, c.vert_at(r.ring[d]), c.vert_at(r.ring[d + 2]));
  return made;
}

}  // namespace concino
