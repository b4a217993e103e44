// to_polys: values at polys from values at verts, as conservation laws and pictures of cells need them.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/poly_chunks.hpp>
#include <concino/fields/detail/values/linear_in_poly.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/mesh/element_map.hpp>

namespace concino {

/// Values at the polys of a mesh from values at its verts: the means of u over the polys. to_verts goes the other way.
/// Needs:  EmbeddedMesh, not a temporary; u[v] is a number for each vert, readable from several threads.
/// Result: a map of double: the mean of the values at the verts and the mean gradient, evaluated at the centroid. So it
///         is exact for linear functions on polys of every shape, and constants stay what they are; on triangles and
///         tets it is the mean of the values. On polys without area or volume, it is this mean, too.
/// Cost:   O(size of the polys) time, in parallel, O(P) memory.
/// Errors: none; values that are not finite make those of their polys not finite.
template<class M, class U>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && requirement::gives_numbers<U, vert_t<M>>
poly_map<M, double> to_polys(M&& m, const U& u) {
  using mesh = std::remove_cvref_t<M>;
  auto result = make_poly_map<double>(m);
  core::poly_chunks<mesh>(m).template for_each<poly_gradients<mesh>>(
      [&](auto& local, const poly_t<mesh>& p, std::size_t) {
        const detail::linear_function f = detail::linear_in_poly(local, m, p, u);
        if constexpr (TriMesh<mesh> || TetMesh<mesh>) result[p] = f.value;  // the mean of the verts is the centroid
        else result[p] = f.gradient == vec3() ? f.value : f(centroid(m, p));
        return 0;
      });
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void to_polys(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void to_polys(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void to_polys(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(EmbeddedMesh<M> && !requirement::gives_numbers<U, vert_t<M>>)
void to_polys(M&&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
