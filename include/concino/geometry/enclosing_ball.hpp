// The smallest ball around points, and the smallest circle around a polygon.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/vec3.hpp>

#include <span>
#include <vector>

namespace concino {

/// All points at a distance of at most `radius` from the centre.
struct enclosing_ball_result {
  vec3 centre;
  double radius = -1;  // in units of the mesh; -1 if there are no points
};

/// A circle in the plane of a polygon.
struct enclosing_circle_result {
  vec3 centre;
  double radius = -1;  // in units of the mesh; -1 if there are no corners
  vec3 normal;         // of the plane, of length 1; 0 if the polygon has no area
};

/// The smallest ball around points, all verts of a mesh or graph, or the verts of a poly.
/// Needs:  Embedded M with verts, or with adj_p2v; points in any order and number, many of which may be equal.
/// Result: the radius is the largest distance of a point from the centre, so it is certain that the ball holds all. No
///         ball is smaller by more than rounding errors, some 1e-15 of the radius. Scales exactly with powers of 2.
/// Cost:   O(n) for n points, expected over the order in which they are added, which is random and the same each time.
/// Errors: invalid_argument if a point is not finite.
/// Source: Welzl 1991, "Smallest enclosing disks (balls and ellipsoids)".
enclosing_ball_result enclosing_ball(std::span<const vec3> points);
template<Embedded M>
  requires requirement::has_verts<M>
enclosing_ball_result enclosing_ball(const M& m) {
  std::vector<vec3> points;
  for (const vert_t<M> v : verts(m)) points.push_back(to_vec3(point(m, v)));
  return enclosing_ball(points);
}
template<EmbeddedMesh M>
enclosing_ball_result enclosing_ball(const M& m, const poly_t<M>& p) {
  std::vector<vec3> points;
  for (const vert_t<M> v : adj_p2v(m, p)) points.push_back(to_vec3(point(m, v)));
  return enclosing_ball(points);
}

/// The smallest circle around a polygon: corners in cyclic order, or a poly of a surface.
/// Needs:  SurfaceMesh M, Embedded; a polygon that may be concave, touch itself or leave its plane.
/// Result: a circle in the plane through the mean of the corners, orthogonal to the vector area, around the projections
///         of the corners. It is as exact as enclosing_ball. Without area it is that of the corners in space. Scales
///         exactly with powers of 2.
/// Cost:   O(n) for n corners, as enclosing_ball.
/// Errors: invalid_argument if a corner is not finite.
/// Source: Welzl 1991, as enclosing_ball.
enclosing_circle_result enclosing_circle(std::span<const vec3> polygon);
template<SurfaceMesh M>
  requires Embedded<M>
enclosing_circle_result enclosing_circle(const M& m, const poly_t<M>& p) {
  std::vector<vec3> points;
  for (const vert_t<M> v : adj_p2v(m, p)) points.push_back(to_vec3(point(m, v)));
  return enclosing_circle(points);
}

// What to write instead of calls that cannot compile.
template<class... T> void enclosing_ball(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void enclosing_ball(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void enclosing_ball(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void enclosing_circle(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void enclosing_circle(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void enclosing_circle(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/geometry/detail/circles/enclosing_ball.ipp>
#endif
