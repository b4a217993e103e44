// rotated: a field of a surface turned by 90 degrees in each poly, so that gradients become the directions of level
// lines.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/parallel.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/operators/corner_gradients.hpp>

namespace concino {

/// A field per poly turned by 90 degrees in the plane of each poly, counter-clockwise about its vector area: rotated(m,
/// gradient(m, u)) is tangent to the level lines of u, with larger values on the right.
/// Needs:  Embedded SurfaceMesh, no temporary; field[p] of every poly, a vec3 or anything with [0], [1], [2], readable
///         from several threads.
/// Result: a map of vec3: the cross product of the unit normal of p and field[p]. Vectors in the plane of a poly keep
///         their length; a part along the normal is lost, so of those rotated twice the projection into the plane
///         changes its sign. If a vector is not finite, neither is its result.
/// Cost:   O(corners) time, in parallel, O(P) memory.
/// Errors: invalid_mesh, naming a poly without area or with points that are not finite.
template<class M, class Field>
  requires requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && Embedded<M> &&
      requirement::gives_points<Field, poly_t<M>>
          poly_map<M, vec3> rotated(M&& m, const Field& field) {
    using mesh = std::remove_cvref_t<M>;
    poly_map<M, vec3> result(m, poly_index_bound(m), detail::unwritten{});
    parallel_for_each(polys(m), [&](const poly_t<mesh>& p) {
      const vec3 axis = normal(m, p);
      if (!is_finite(axis) || axis == vec3()) detail::throw_no_measure("rotated", m, p);
      result[p] = cross(axis, to_vec3(field[p]));
    });
    return result;
  }

// What to write instead of calls that cannot compile.
template<class... T> void rotated(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void rotated(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void rotated(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_vectors_at_polys>>
  requires(SurfaceMesh<M> && Embedded<M> && !requirement::gives_points<U, poly_t<M>>)
void rotated(M&&, const U&, ...) = delete;  // a vector at each poly: make_poly_map<vec3>(m)

}  // namespace concino
