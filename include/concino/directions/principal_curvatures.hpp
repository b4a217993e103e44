// principal_curvatures(m): how much a surface bends at each vert, and in which directions.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/directions/detail/curvature/fitted_curvature.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/mesh/element_map.hpp>

#include <cstddef>
#include <vector>

namespace concino {

/// The principal curvatures and directions at the verts of a surface: auto k = principal_curvatures(m); then k[v].k1
/// and k[v].d1 are the larger curvature and its direction, k[v].k2 and k[v].d2 the smaller ones.
/// Needs:  Embedded SurfaceMesh M, no temporary, of polys of any shape.
/// Result: a map. At each vert it is that of the quadratic polynomial that fits the verts of its polys, and of their
///         polys, best. The sign is that for vert_normal as normal: a sphere with outward normals has positive
///         curvatures. On a smooth surface the error falls with the size of polys, and with its square where they are
///         alike. Where both curvatures are equal any directions are principal. At sharp edges the values depend on the
///         size of polys. Verts without polys, or without a normal, have curvatures and directions 0.
/// Cost:   a small least-squares problem for each vert.
/// Errors: invalid_mesh if a point is not finite.
/// Source: Cazals and Pouget 2005, "Estimating differential quantities using polynomial fitting of osculating jets", of
///         degree 2.
template<class M>
  requires requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && Embedded<M>
vert_map<M, principal_curvature> principal_curvatures(M&& m) {
  for (const vert_t<M> v : verts(m))
    if (!is_finite(to_vec3(point(m, v))))
      core::throw_joined<invalid_mesh>({"principal_curvatures: the point of vert ", index_of(m, v), " is not finite"});
  auto result = make_vert_map<principal_curvature>(m);
  std::vector<std::size_t> found_by(vert_index_bound(m));  // the number of the last vert that found each, from 1
  std::size_t number = 0;
  std::vector<vert_t<M>> ring;
  std::vector<vec3> offsets;
  for (const vert_t<M> v : verts(m)) {
    ++number;
    const vec3 normal = vert_normal(m, v), centre = to_vec3(point(m, v));
    if (!(norm(normal) > 0)) continue;
    ring.assign(1, v), offsets.clear();
    found_by[index_of(m, v)] = number;
    for (std::size_t i = 0, end_of_ring = 1; i < end_of_ring; ++i) {
      const vert_t<M> from = ring[i];  // a copy: the ring grows
      for (const poly_t<M> p : adj_v2p(m, from))
        for (const vert_t<M> w : adj_p2v(m, p)) {
          if (found_by[index_of(m, w)] == number) continue;
          found_by[index_of(m, w)] = number;
          ring.push_back(w), offsets.push_back(to_vec3(point(m, w)) - centre);
        }
      if (i == 0) end_of_ring = ring.size();
    }
    result[v] = detail::fit_curvature(offsets, normal);
  }
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void principal_curvatures(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void principal_curvatures(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void principal_curvatures(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
