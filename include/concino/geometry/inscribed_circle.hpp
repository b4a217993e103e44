// The largest circle inside a polygon.
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

struct inscribed_circle_options {
  double tolerance = 1e-9;  // of the radius, as a part of it; from 1e-12 to 1
  std::size_t max_parts = 1u << 20;  // into which the polygon is divided; a very thin spiral may need more. >= 1
};

/// A circle inside a polygon, and a bound for all such circles.
struct inscribed_circle_result {
  vec3 centre;            // in the plane of the polygon
  double radius = 0;      // the distance of the centre from the edges, in units of the mesh
  double max_radius = 0;  // no circle inside the polygon has a larger one
  vec3 normal;            // of the plane, of length 1
};

namespace detail {

inscribed_circle_result largest_circle_inside(const core::flat_polygon& flat, const inscribed_circle_options& options);

}  // namespace detail

/// The largest circle inside a polygon: corners in cyclic order, or a poly of a surface.
/// Needs:  SurfaceMesh M, Embedded. The polygon is simple, seen along its vector area; it may be concave, and leave its
///         plane.
/// Result: a circle in the plane through the mean of the corners, orthogonal to the vector area, inside the projection
///         of the polygon. Its radius is at least (1 - tolerance) max_radius, up to rounding errors of 1e-14 of the
///         size of the polygon. If max_parts is too small for that, max_radius is larger, but right. Where there are
///         several largest circles, it is one of them. Scales exactly with powers of 2.
/// Cost:   O(n) for the n corners of a convex polygon. For others O(n) times the number of parts, some hundred, and
///         more for long and thin polygons.
/// Errors: invalid_argument, of a poly of a mesh invalid_mesh, if a corner is not finite, if two edges touch other than
///         at their corner, or if there is no area; invalid_argument if an option is out of range.
/// Source: branch and bound; bounds by linear programmes: Seidel 1991, "Small-dimensional linear programming and convex
///         hulls made easy".
inscribed_circle_result inscribed_circle(std::span<const vec3> polygon, const inscribed_circle_options& options = {});
template<SurfaceMesh M>
  requires Embedded<M>
inscribed_circle_result inscribed_circle(const M& m, const poly_t<M>& p, const inscribed_circle_options& options = {}) {
  std::vector<vec3> points;
  for (const vert_t<M> v : adj_p2v(m, p)) points.push_back(to_vec3(point(m, v)));
  return detail::largest_circle_inside(core::checked_simple_polygon(points, "inscribed_circle", index_of(m, p)),
                                       options);
}

// What to write instead of calls that cannot compile.
template<class... T> void inscribed_circle(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void inscribed_circle(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void inscribed_circle(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/geometry/detail/circles/inscribed_circle.ipp>
#endif
