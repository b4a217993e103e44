// Isosurfaces of distributed meshes: isosurface(d, u, c) in pieces, gather_isosurface(d, u, c) on the first process.
// Needs: PETSc 3.18 with MPI (Debian: petsc-dev).
#pragma once

#include <concino/adapters/detail/distributed/distributed_ghost_values.hpp>
#include <concino/adapters/detail/distributed/distributed_polys.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/concepts/maps.hpp>
#include <concino/level_sets/isosurface.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <initializer_list>
#include <utility>

namespace concino {

/// The piece of this process of the isosurface of the whole mesh. All its processes call it together.
/// Needs:  a distributed mesh of a volume; u[v] is a number for each local vert; those of ghosts are not read. The same
///         values on all processes, one or several.
/// Result: as isosurface, the polygons in the polys of this process. Each polygon of the isosurface of the mesh that
///         was divided is in exactly one piece, so areas and numbers of polys sum to those of one process. Verts
///         between pieces are in each of them.
/// Cost:   as isosurface of the local mesh, and one message to and from each process with common verts.
/// Errors: as isosurface; verts and polys are named by their global numbers. Every error is thrown on all processes.
/// Source: as isosurface.
template<class To = polygonmesh, class M, class U, class V = std::initializer_list<double>>
  requires VolumeMesh<M> && requirement::gives_numbers<U, vert_t<M>> && requirement::is_value_list<V> &&
      requirement::is_level_surface_mesh<To>
          level_surface<distributed<M>, To> isosurface(const distributed<M>& m, const U& u, const V& values) {
    detail::on_all(m.communicator(), [&] { detail::check_vert_values(m, u, "isosurface"); });
    const auto all = detail::values_with_ghosts(m, u);
    level_surface<distributed<M>, To> piece;
    detail::on_all(m.communicator(), [&] {
      const auto is_own = [&](const poly_t<M>& p) { return !m.is_ghost(p); };
      piece = detail::find_isosurface<To>(m, all, values, "isosurface", is_own);
    });
    return piece;
  }

/// The isosurface of the whole mesh, joined on the first process. All processes call it together.
/// Needs:  as isosurface of a distributed mesh.
/// Result: on the first process the mesh of isosurface of the mesh that was divided, with the same polys in the same
///         order; on others an empty mesh.
/// Cost:   as isosurface of a distributed mesh, twice on the first process: it gets the polys that are cut, and those
///         that share a face with them.
/// Errors: as isosurface of a distributed mesh.
/// Source: as isosurface.
template<class To = polygonmesh, class M, class U, class V = std::initializer_list<double>>
  requires VolumeMesh<M> && requirement::gives_numbers<U, vert_t<M>> && requirement::is_value_list<V> &&
      requirement::is_level_surface_mesh<To> To gather_isosurface(const distributed<M>& m, const U& u,
                                                                  const V& values) {
    auto is_cut = make_poly_map<bool>(m, false);
    for (const poly_t<M>& p : isosurface(m, u, values).polys) is_cut[p] = true;
    exchange_ghosts(is_cut);
    const auto gathered = detail::gather_polys(m, [&](const poly_t<M>& p) {
      if (is_cut[p]) return true;
      for (const poly_t<M> q : adj_p2p(m, p))
        if (is_cut[q]) return true;
      return false;
    });
    const auto of_vert = detail::gather_values(m, gathered, u);
    To whole;
    detail::on_all(m.communicator(), [&] {
      if (m.rank() == 0) whole = detail::find_isosurface<To>(gathered.mesh, of_vert, values, "isosurface").mesh;
    });
    return whole;
  }

}  // namespace concino
