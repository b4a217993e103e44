// The width of polygons, polyhedra and points: the smallest distance of two parallel lines or planes around them.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/support/flat_polygon.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace concino {

/// A width, and the direction in which it is measured.
struct width_result {
  double width = 0;  // in units of the mesh
  vec3 direction;    // orthogonal to the lines or planes, of length 1; 0 if there are no points
};

namespace detail {

width_result width_of_points(std::span<const vec3> points);
width_result width_of_polygon(std::span<const vec3> points);

}  // namespace detail

/// The smallest distance of two parallel planes around points or around the verts of a poly of a volume, or of two
/// parallel lines around a poly of a surface, in its plane.
/// Needs:  EmbeddedMesh M; points in any order and number; polys of any shape.
/// Result: that of the convex hull; exact up to rounding errors of 1e-15 of the size. Points in one plane have width 0.
///         The lines around a poly of a surface are in the plane orthogonal to its vector area; without area the width
///         is 0. Scales exactly with powers of 2.
/// Cost:   O(n log n) for n points, and O(h^2) for h edges of the hull in space.
/// Errors: invalid_argument if a point is not finite.
/// Source: Houle and Toussaint 1988, "Computing the width of a set"; Shamos 1978 for lines.
inline width_result width(std::span<const vec3> points) { return detail::width_of_points(points); }
template<EmbeddedMesh M>
width_result width(const M& m, const poly_t<M>& p) {
  std::vector<vec3> points;
  for (const vert_t<M> v : adj_p2v(m, p)) points.push_back(to_vec3(point(m, v)));
  if constexpr (SurfaceMesh<M>) return detail::width_of_polygon(points);  // lines in the plane of a polygon
  else return detail::width_of_points(points);
}

// What to write instead of calls that cannot compile.
template<class... T> void width(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void width(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void width(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/geometry/detail/hull/width.ipp>
#endif
