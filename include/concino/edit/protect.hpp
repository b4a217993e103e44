// Invariants that keep chosen edges and faces.
#pragma once

#include <concino/edit/detail/edge_ring.hpp>
#include <concino/edit/support/typed_edit.hpp>

namespace concino {

namespace detail {

/// Whether no face that the edit removes is in the map.
template<class M, class F>
bool removes_no_face(const cavity_builder<M>& c, const M& m, const F& map) {
  return core::for_each_removed<3>(c, [&](const std::array<unsigned, 3>& s) {
    face_t<M> f;
    return !find_face(m, c.vert_at(s[0]), c.vert_at(s[1]), c.vert_at(s[2]), f) || !map(f);
  });
}
template<class M, class F>
bool removes_no_face(const general_cavity<M>& c, const M&, const F& map) {
  return core::for_each_removed_face(c, [&](const face_t<M>& f) { return !map(f); });
}

}  // namespace detail

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
    return core::with_cavity_of_edit(e, m, "protect_edges", [&](const auto& c) -> permission {
      const bool none = core::for_each_removed_edge(c, m, [&](const edge_t<M>& x) { return !map(x); });
      return none ? permission{} : permission{refusal::invariant, "protect_edges: a protected edge would be removed"};
    });
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
    return core::with_cavity_of_edit(e, m, "protect_faces", [&](const auto& c) -> permission {
      const bool none = detail::removes_no_face(c, m, map);
      return none ? permission{} : permission{refusal::invariant, "protect_faces: a protected face would be removed"};
    });
  };
}

}  // namespace concino
