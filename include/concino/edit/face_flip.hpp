// Flips a face between two tets (2-3): it is replaced by the edge between the two verts opposite to it, which has three
// tets.
#pragma once

#include <concino/edit/detail/facet_flip.hpp>

namespace concino {

/// Whether f can be flipped: it has two tets, which are consistently oriented, and the verts opposite to it are not
/// joined yet. The invariants hold.
/// Needs:  EditableVolumeMesh M, a face of m.      Result: true, or the reason. Only no_inversion asks whether the
///         three tets are not inverted.
/// Cost:   the edges at an opposite vert.          Errors: invalid_mesh if f is not a face of m.
template<EditableVolumeMesh M>
permission can_face_flip(const M& m, face_t<M> f, const edit_options& options = {}) {
  detail::check_element(m, f, "can_face_flip", "face");
  return detail::can_flip_facet(m, f, options.keep);
}

/// Replaces f and its two tets by three tets at the edge between the two verts opposite to f. edge_flip of this edge is
/// the inverse.
/// Needs:  EditableVolumeMesh M.
/// Result: the new edge, or the reason why not. Two of the new tets keep the descriptors of the old ones. Other
///         descriptors remain valid, apart from f.
/// Cost:   the elements at the verts of the tets, but O(mesh) the first time.
/// Errors: invalid_mesh if f is not a face of m. The mesh is unchanged then, also if memory runs out.
/// Source: Freitag and Ollivier-Gooch 1997, "Tetrahedral mesh improvement using swapping and smoothing".
template<EditableVolumeMesh M>
edge_result<M> face_flip(M& m, face_t<M> f, const edit_options& options = {}) {
  detail::check_element(m, f, "face_flip", "face");
  return detail::flip_facet(m, f, options.keep);
}

}  // namespace concino
