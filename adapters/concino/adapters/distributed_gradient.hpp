// Gradients on distributed meshes: gradient(d, u), vert_gradient(d, u).
// Needs: MPI (Debian: petsc-dev brings it; libopenmpi-dev).
#pragma once

#include <concino/adapters/detail/distributed/distributed_ghost_values.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/concepts/maps.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/operators/gradient.hpp>

namespace concino {

namespace detail {

template<class M, class U>
poly_map<distributed<M>, vec3> distributed_gradient(const distributed<M>& m, const U& u) {
  const auto values = values_with_ghosts(m, u);
  auto r = make_poly_map<vec3>(m);
  on_all(m.communicator(), [&] { r = find_gradient(m, values); });
  return r;
}

template<class M, class U>
vert_map<distributed<M>, vec3> distributed_vert_gradient(const distributed<M>& m, const U& u) {
  const auto values = values_with_ghosts(m, u);
  auto r = make_vert_map<vec3>(m);
  on_all(m.communicator(), [&] { r = find_vert_gradient(m, values); });
  exchange_ghosts(r);
  return r;
}

}  // namespace detail

/// gradient of the whole mesh. All its processes call it together.
/// Needs:  a distributed mesh; u[v] is a number for each local vert. Those of ghosts are not read.
/// Result: as gradient of the mesh that was divided, at local polys, ghosts included.
/// Cost:   as gradient of the local mesh, and one message to and from each process with common verts.
/// Errors: as gradient; polys are named by their global numbers. Every error is thrown on all processes.
/// Source: as gradient.
template<class M, class U>
  requires requirement::gives_numbers<U, vert_t<M>> poly_map<distributed<M>, vec3> gradient(const distributed<M>& m,
                                                                                            const U& u) {
    return detail::distributed_gradient(m, u);
  }
template<class M, class U>
  requires requirement::gives_numbers<U, vert_t<M>> poly_map<distributed<M>, vec3> gradient(distributed<M>& m,
                                                                                            const U& u) {
    return detail::distributed_gradient(m, u);
  }

/// vert_gradient of the whole mesh. All its processes call it together.
/// Needs:  as gradient of a distributed mesh.
/// Result: as vert_gradient of the mesh that was divided, at local verts, ghosts included.
/// Cost:   as vert_gradient of the local mesh, and two messages to and from each process with common verts.
/// Errors: as gradient of a distributed mesh.
/// Source: as vert_gradient.
template<class M, class U>
  requires requirement::gives_numbers<U, vert_t<M>> vert_map<distributed<M>, vec3> vert_gradient(
      const distributed<M>& m, const U& u) {
    return detail::distributed_vert_gradient(m, u);
  }
template<class M, class U>
  requires requirement::gives_numbers<U, vert_t<M>> vert_map<distributed<M>, vec3> vert_gradient(distributed<M>& m,
                                                                                                 const U& u) {
    return detail::distributed_vert_gradient(m, u);
  }

}  // namespace concino
