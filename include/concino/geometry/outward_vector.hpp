// Outward normals of the facets of a poly, scaled by their measure: the vectors of the divergence theorem in either
// dimension.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/geometry/normals.hpp>

namespace concino {

/// The outward normal of poly p at its facet x, with the measure of x as length.
/// Needs:  EmbeddedMesh; x is a facet of p.
/// Result: for a face of a volume its area_vector, with the sign of face_is_outward. For an edge of a surface the edge,
///         rotated by a right angle in the plane of p; if p is not flat, in the plane normal to its area_vector. The
///         vectors over all facets of p sum to 0 if p is closed. Units of measure(m, x), scales exactly; 0 for a
///         degenerate edge or face and at edges of a poly without area; components too large for a double are infinite.
/// Cost:   O(verts of p) of a surface, O(verts of x) in a volume.      Errors: none.
template<SurfaceMesh M>
  requires Embedded<M>
vec3 outward_vector(const M& m, const poly_t<M>& p, const edge_t<M>& x) {
  for (const auto& [e, from, to] : oriented_edges(m, p)) {
    if (!(e == x)) continue;
    const vec3 a = to_vec3(point(m, from)), b = to_vec3(point(m, to)), n = normal(m, p);
    const vec3 step = b - a;
    if (is_finite(step)) return cross(step, n);
    return 2 * cross(0.5 * b - 0.5 * a, n);
  }
  return {};
}
template<VolumeMesh M>
  requires Embedded<M>
vec3 outward_vector(const M& m, const poly_t<M>& p, const face_t<M>& x) {
  const vec3 a = area_vector(m, x);
  return face_is_outward(m, p, x) ? a : -a;
}

// What to write instead of calls that cannot compile.
template<class... T> void outward_vector(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void outward_vector(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void outward_vector(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino
