// slice: the intersection of a mesh with a plane.
#pragma once

#include <concino/level_sets/detail/cut/plane_heights.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/level_sets/isosurface.hpp>

namespace concino {

/// The intersection of a mesh with a plane: the level set of the height above it.
/// Needs:  EmbeddedMesh; a plane with a normal of any length but 0.
/// Result: of a surface, lines as of isolines, in the plane up to rounding. Of a volume, filled polygons as of
///         isosurface, seen counter-clockwise from above the plane; slice<trimesh> gives triangles. Where the mesh only
///         touches the plane, there is nothing.
/// Cost:   that of isolines or isosurface.
/// Errors: invalid_argument if the plane has no normal or is not finite; invalid_argument that names a vert whose
///         height is not a number. Others as isosurface.
/// Source: paper section 2.2, the slicing tool.
template<SurfaceMesh M>
  requires Embedded<M>
std::vector<level_line<M>> slice(const M& m, const plane& p) {
  return detail::find_isolines(m, detail::heights_above(m, p, "slice"), 0.0, "slice");
}
template<class To = polygonmesh, VolumeMesh M>
  requires Embedded<M> && requirement::is_level_surface_mesh<To>
level_surface<M, To> slice(const M& m, const plane& p) {
  return detail::find_isosurface<To>(m, detail::heights_above(m, p, "slice"), 0.0, "slice");
}

// What to write instead of calls that cannot compile.
template<class... T> void slice(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void slice(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
