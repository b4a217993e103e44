// The kernel of a polygon or a polyhedron: the part from which all of it is visible.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/support/flat_polygon.hpp>
#include <concino/mesh/arrays.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace concino {

/// The kernel of a polygon: a convex polygon in its plane.
struct polygon_kernel {
  std::vector<vec3> corners;  // counter-clockwise as the polygon; none if the kernel is empty
  double area = 0;            // in units of the mesh, squared
  vec3 witness;               // the centroid of the kernel; not a number if it is empty
  bool is_empty() const { return corners.empty(); }
};

/// The kernel of a polyhedron: a convex polyhedron.
struct polyhedron_kernel {
  surface_arrays surface;  // polygonmesh(k.surface) is a mesh of it, whose normals point outward; empty as the kernel
  double volume = 0;       // in units of the mesh, cubed
  vec3 witness;            // the centroid of the kernel; not a number if it is empty
  bool is_empty() const { return surface.points.empty(); }
};

namespace detail {

polygon_kernel kernel_in_plane(const core::flat_polygon& flat);

/// The faces are loops of points, counter-clockwise seen from outside.
/// Errors: invalid_mesh that names poly number `poly` if a point is not finite.
polyhedron_kernel kernel_inside_faces(const std::vector<std::vector<vec3>>& faces, std::size_t poly);

}  // namespace detail

/// The kernel of a polygon: corners in cyclic order, or a poly of a surface.
/// Needs:  SurfaceMesh M, Embedded. The polygon is simple, seen along its vector area; it may leave its plane.
/// Result: the part of the projected polygon from which all of it is visible, in the plane through the mean of its
///         corners: all of it if it is convex, and nothing if it is not star-shaped. A kernel without area counts as
///         empty. It is exact up to rounding errors of 1e-15 of the size of the polygon, and scales exactly with powers
///         of 2. metric::star_shapedness is the area of it, as a part of the polygon.
/// Cost:   O(n k) for n corners, of which k remain in the kernel.
/// Errors: invalid_argument, of a poly of a mesh invalid_mesh, if a corner is not finite, if two edges touch other than
///         at their corner, or if there is no area.
/// Source: Sutherland and Hodgman 1974, "Reentrant polygon clipping", by the lines of all edges.
polygon_kernel kernel(std::span<const vec3> polygon);
template<SurfaceMesh M>
  requires Embedded<M>
polygon_kernel kernel(const M& m, const poly_t<M>& p) {
  std::vector<vec3> points;
  for (const vert_t<M> v : adj_p2v(m, p)) points.push_back(to_vec3(point(m, v)));
  return detail::kernel_in_plane(core::checked_simple_polygon(points, "kernel", index_of(m, p)));
}

/// The kernel of a poly of a volume.
/// Needs:  VolumeMesh M, Embedded; faces of p that close, oriented as face_is_outward says.
/// Result: as that of a polygon. Faces that are not planar are fans of triangles about the means of their verts, as
///         elsewhere. An inverted cell has none. metric::star_shapedness is the volume of it, as a part of the cell.
/// Cost:   O(f k) for f facets and k verts of the kernel, and O(k^2).
/// Errors: invalid_mesh if a vert is not finite.
/// Source: as of a polygon, by the planes of all facets.
template<VolumeMesh M>
  requires Embedded<M>
polyhedron_kernel kernel(const M& m, const poly_t<M>& p) {
  std::vector<std::vector<vec3>> loops;
  for (const face_t<M> f : adj_p2f(m, p)) {
    loops.emplace_back();
    for (const vert_t<M> v : adj_f2v(m, f)) loops.back().push_back(to_vec3(point(m, v)));
    if (!face_is_outward(m, p, f)) std::reverse(loops.back().begin(), loops.back().end());
  }
  return detail::kernel_inside_faces(loops, index_of(m, p));
}

// What to write instead of calls that cannot compile.
template<class... T> void kernel(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void kernel(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void kernel(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/geometry/detail/kernel.ipp>
#endif
