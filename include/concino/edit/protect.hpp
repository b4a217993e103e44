// Invariants that keep chosen edges and faces of triangles and tets.
#pragma once

#include <concino/edit/detail/edge_ring.hpp>
#include <concino/edit/support/typed_edit.hpp>

namespace concino {

/// Refuses edits of m that remove an edge for which `is_protected` is true: by a split, a collapse or a flip.
/// Needs:  EditableMesh M; a map of edges, or a predicate, bool(edge_t<M>). One that is large or owns memory must be an
///         lvalue that outlives the invariant.
/// Result: an invariant for `keep`.
/// Cost:   at each edit, the edges of its old polys.
/// Errors: an edit throws invalid_argument if its mesh is not m; the mesh is unchanged then.
template<EditableMesh M, class F>
  requires(core::caller_map<std::remove_cvref_t<F>>::template can_hold<F>)
invariant protect_edges(const M& m, F&& is_protected) {
  return [&m, map = core::caller_map<std::remove_cvref_t<F>>(is_protected)](const proposed_edit& e) -> permission {
    const auto& c = core::cavity_of_edit(e, m, "protect_edges");
    const bool none = core::for_each_removed<2>(c, [&](const std::array<unsigned, 2>& s) {
      return !map(detail::edge_between_verts(m, c.vert_at(s[0]), c.vert_at(s[1])));
    });
    return none ? permission{} : permission{refusal::invariant, "protect_edges: a protected edge would be removed"};
  };
}

/// Refuses edits of m that remove a face for which `is_protected` is true.
/// Needs:  EditableVolumeMesh M; a map of faces, or a predicate, bool(face_t<M>), as for protect_edges.
/// Result: an invariant for `keep`.
/// Cost:   at each edit, the faces at the verts of its old polys.
/// Errors: an edit throws invalid_argument if its mesh is not m; the mesh is unchanged then.
template<EditableVolumeMesh M, class F>
  requires(core::caller_map<std::remove_cvref_t<F>>::template can_hold<F>)
invariant protect_faces(const M& m, F&& is_protected) {
  return [&m, map = core::caller_map<std::remove_cvref_t<F>>(is_protected)](const proposed_edit& e) -> permission {
    const auto& c = core::cavity_of_edit(e, m, "protect_faces");
    const bool none = core::for_each_removed<3>(c, [&](const std::array<unsigned, 3>& s) {
      face_t<M> f;
      return !detail::find_face(m, c.vert_at(s[0]), c.vert_at(s[1]), c.vert_at(s[2]), f) || !map(f);
    });
    return none ? permission{} : permission{refusal::invariant, "protect_faces: a protected face would be removed"};
  };
}

}  // namespace concino
