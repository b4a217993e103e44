// Mean value coordinates of points in a cage: a coarse surface around a shape, or a polygon, that bends it.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/deform/cage_weights.hpp>
#include <concino/deform/detail/cages/mean_value.hpp>

#include <utility>
#include <vector>

namespace concino {

/// Mean value coordinates: weights of the verts of a cage for points inside and outside, as smooth functions of the
/// points. auto w = cage_coordinates(cage, m); auto moved = w.points_of(bent_cage);
/// Needs:  cage: an Embedded SurfaceMesh, closed and consistently oriented, of polys of any shape, convex or not; or
///         the corners of a polygon in the plane of x and y, in any container, whose z is not read. It may have several
///         components and touch itself. points: a mesh, no temporary, whose verts they are, or any container.
/// Result: weights that sum to 1 and reproduce linear functions: points_of(cage) are the points. On the cage the
///         weights are those of the poly, edge or vert that a point lies on, linear on each triangle. A poly of more
///         corners is cut into triangles around the mean of its corners, whose weight they share; if one of them were
///         turned, by diagonals. Inside of convex cages weights are positive; elsewhere some may be negative. The
///         orientation of the cage has no effect. Exact in scale by powers of 2.
/// Cost:   O(points x triangles of the cage) time, parallel, and O(points x verts of the cage) memory.
/// Errors: invalid_mesh if the cage has no polys, a point that is not finite or no size, or names an edge at which it
///         is open or not consistently oriented. invalid_argument if a point is not finite, or a polygon has less
///         than 3 corners or no size. The same if a point is so far away, beyond some 100 sizes of the cage, that its
///         weights would not reproduce it to 1e-9 of the distance.
/// Source: Floater 2003, "Mean value coordinates"; Hormann and Floater 2006 for polygons of any shape; Ju, Schaefer and
///         Warren 2005, "Mean value coordinates for closed triangular meshes". The weights in a triangle solve three
///         equations by orthogonal projections, which are accurate where its plane goes through the point.
template<class C, class P>
  requires SurfaceMesh<C> && Embedded<C> && core::iterable<P>
cage_weights cage_coordinates(const C& cage, const P& points) {
  constexpr const char* caller = "cage_coordinates";
  const auto flat = detail::make_flat_cage(detail::cage_polys_of(cage, caller), caller);
  return {flat.num_verts, detail::mean_value_weights(flat, detail::points_by_index(points, caller),
                                                     detail::indices_of_points(points), caller)};
}
template<class C, class M>
  requires SurfaceMesh<C> && Embedded<C> && requirement::is_lvalue_or_view<M> && Embedded<M> &&
      requirement::has_verts<M>
          mesh_cage_weights<std::remove_cvref_t<M>> cage_coordinates(const C& cage, M&& m) {
    constexpr const char* caller = "cage_coordinates";
    const auto flat = detail::make_flat_cage(detail::cage_polys_of(cage, caller), caller);
    return {m, cage_weights(flat.num_verts, detail::mean_value_weights(flat, detail::points_by_index(m, caller),
                                                                       detail::indices_of_points(m), caller))};
  }
template<class C, class P>
  requires core::iterable<C> && core::iterable<P>
cage_weights cage_coordinates(const C& polygon, const P& points) {
  constexpr const char* caller = "cage_coordinates";
  const auto corners = detail::points_by_index(polygon, caller);
  return {corners.size(), detail::mean_value_weights_of_polygon(corners, detail::points_by_index(points, caller),
                                                                detail::indices_of_points(points), caller)};
}
template<class C, class M>
  requires core::iterable<C> && requirement::is_lvalue_or_view<M> && Embedded<M> && requirement::has_verts<M>
mesh_cage_weights<std::remove_cvref_t<M>> cage_coordinates(const C& polygon, M&& m) {
  constexpr const char* caller = "cage_coordinates";
  const auto corners = detail::points_by_index(polygon, caller);
  return {
      m, cage_weights(corners.size(), detail::mean_value_weights_of_polygon(corners, detail::points_by_index(m, caller),
                                                                            detail::indices_of_points(m), caller))};
}

// What to write instead of calls that cannot compile.
template<class... T> void cage_coordinates(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void cage_coordinates(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
