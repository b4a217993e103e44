// The outer polygons of a mesh: the polys of a surface, or the boundary faces of a volume.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/core/mistakes.hpp>

namespace concino {

namespace detail {

template<class M, class R, class Visit>
void visit_outer_faces(const M& m, const R& some, const Visit& visit) {
  for (const face_t<M> f : some) {
    if (!is_boundary(m, f)) continue;
    const auto& inside = adj_f2p(m, f);
    const poly_t<M> p = *inside.begin();
    visit(p, adj_f2v(m, f), face_is_outward(m, p, f));
  }
}

}  // namespace detail

/// Calls visit(p, loop, is_outward) for each outer polygon of m, or for those at vert v. In a surface p is the polygon, in a
/// volume the poly of the face. loop is the range of its verts; is_outward says whether they are counter-clockwise seen from outside.
/// Needs:  AnyMesh; visit takes poly_t<M>, a range of verts that lives as long as the call, and bool.
/// Result: none. It visits all polys of a surface, or the faces of a volume with exactly one poly, in the order of the mesh.
/// Cost:   O(polys) of a surface, O(faces) of a volume; those at v.      Errors: those of visit.
template<SurfaceMesh M, class Visit>
void for_each_outer_polygon(const M& m, const Visit& visit) {
  for (const poly_t<M> p : polys(m)) visit(p, adj_p2v(m, p), true);
}
template<VolumeMesh M, class Visit>
void for_each_outer_polygon(const M& m, const Visit& visit) { detail::visit_outer_faces(m, faces(m), visit); }
template<SurfaceMesh M, class Visit>
void for_each_outer_polygon(const M& m, const vert_t<M>& v, const Visit& visit) {
  for (const poly_t<M> p : adj_v2p(m, v)) visit(p, adj_p2v(m, p), true);
}
template<VolumeMesh M, class Visit>
void for_each_outer_polygon(const M& m, const vert_t<M>& v, const Visit& visit) { detail::visit_outer_faces(m, adj_v2f(m, v), visit); }

// What to write instead of calls that cannot compile.
template<class... T> void for_each_outer_polygon(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter

}  // namespace concino
