// lowest_element: the vert, edge, face or poly of the lowest dimension that contains a place of a mesh.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/geometry/detail/lowest_element.hpp>
#include <concino/mesh/mesh_point.hpp>

namespace concino {

/// The same place at the element of the lowest dimension that contains it: auto x = lowest_element(m,
/// mesh_point<M>{*tree.locate(y), y}). A place of a poly that lies on one of its faces, edges or verts is a place of
/// that. Lines, geodesics and distances start from there.
/// Needs:  EmbeddedMesh. Of a vert or an edge, the position is not read.
/// Result: the nearest vert, else edge, else face of a volume, that is at most 1e-12 of the diameter or eight units of
///         rounding of the coordinates away; else the element of x. The position is that of the element found: of a
///         vert its point, of an edge the point at the parameter. Where the position lies outside the poly, it is the
///         nearest point of it. Faces and polygons that are not planar are those of triangulate_polygon; places away
///         from them by no more than their extent along the normal belong to them.
/// Cost:   O(size of the poly).
/// Errors: invalid_mesh if the element is not one of the mesh, or has points that are not finite. invalid_argument if
///         the position is not finite, or farther than 1e-6 of the diameter outside the element; if a parameter is not
///         in [0, 1].
template<EmbeddedMesh M>
mesh_point<M> lowest_element(const M& m, const mesh_point<M>& x) {
  return detail::lowest_element_of(m, x, "lowest_element", "place");
}

// What to write instead of calls that cannot compile.
template<class... T> void lowest_element(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void lowest_element(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
