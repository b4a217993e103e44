// Geodesic distances on distributed meshes: heat_geodesics(d, sources).
// Needs: PETSc 3.18 with MPI (Debian: petsc-dev), and a petsc_session in main.
#pragma once

#include <concino/adapters/detail/distributed/distributed_geodesics.hpp>
#include <concino/adapters/detail/distributed/distributed_system.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/petsc.hpp>
#include <concino/core/error.hpp>
#include <concino/fields/heat_geodesics.hpp>

#include <initializer_list>
#include <utility>

namespace concino {

namespace detail {

template<class M, class S>
vert_map<distributed<M>, double> distributed_heat_geodesics(const distributed<M>& m, const S& sources,
                                                            const heat_geodesics_options& options,
                                                            const petsc& solver) {
  on_all(m.communicator(), [&] {
    if (options.clamp) throw unsupported("heat_geodesics: on distributed meshes there is no clamp");
    check_heat_time(options.time);
  });
  return distributed_geodesics<M>(m, options, solver).distance_from(sources);
}

}  // namespace detail

/// heat_geodesics of the whole mesh, which all its processes compute together.
/// Needs:  a distributed mesh. sources: as for heat_geodesics, local verts; each process gives those of its verts, or
///         none, and may repeat those of its ghosts. solver: a petsc, whose communicator is replaced by that of the
///         mesh.
/// Result: as heat_geodesics of the mesh that was divided, at local verts, ghosts included. A vert that several
///         processes give counts once, with the least initial distance. A factorisation by MUMPS gives the distances
///         of one process but for rounding; other preconditioners at a tolerance of 1e-12 differ by less than 1e-6 of
///         the largest distance, but need a time of at least 1e-5 squared edges. solver.iterations() and
///         solver.residual() describe the last solve. progress and profiler are not used.
/// Cost:   as that of one process divided by their number, and messages between neighbours in each iteration. Without
///         a factorisation, heat takes a solve for each 12 sqrt(time) of distance. Every process holds all sources. The
///         first one gets the polys within a distance of 3 sqrt(time) of them, or farther by initial distances.
/// Errors: as heat_geodesics; verts and polys are named by their global numbers. unsupported for clamp. Every error is
///         thrown on all processes.
/// Source: as heat_geodesics.
template<class M, class S, class Solver = petsc>
  requires(detail::gives_verts<M, S> || detail::gives_distances<M, S>) && detail::solver_for_distributed<Solver>
vert_map<distributed<M>, double> heat_geodesics(const distributed<M>& m, const S& sources,
                                                const heat_geodesics_options& options = {}, Solver&& solver = {}) {
  return detail::distributed_heat_geodesics(m, sources, options, solver);
}
template<class M, class S, class Solver = petsc>
  requires(detail::gives_verts<M, S> || detail::gives_distances<M, S>) && detail::solver_for_distributed<Solver>
vert_map<distributed<M>, double> heat_geodesics(distributed<M>& m, const S& sources,
                                                const heat_geodesics_options& options = {}, Solver&& solver = {}) {
  return detail::distributed_heat_geodesics(m, sources, options, solver);
}
template<class M, class Solver = petsc>
  requires detail::solver_for_distributed<Solver>
vert_map<distributed<M>, double> heat_geodesics(const distributed<M>& m, std::initializer_list<vert_t<M>> sources,
                                                const heat_geodesics_options& options = {}, Solver&& solver = {}) {
  return detail::distributed_heat_geodesics(m, sources, options, solver);
}
template<class M, class Solver = petsc>
  requires detail::solver_for_distributed<Solver>
vert_map<distributed<M>, double> heat_geodesics(distributed<M>& m, std::initializer_list<vert_t<M>> sources,
                                                const heat_geodesics_options& options = {}, Solver&& solver = {}) {
  return detail::distributed_heat_geodesics(m, sources, options, solver);
}
template<class M, class Solver = petsc>
  requires detail::solver_for_distributed<Solver>
vert_map<distributed<M>, double> heat_geodesics(const distributed<M>& m,
                                                std::initializer_list<std::pair<vert_t<M>, double>> sources,
                                                const heat_geodesics_options& options = {}, Solver&& solver = {}) {
  return detail::distributed_heat_geodesics(m, sources, options, solver);
}
template<class M, class Solver = petsc>
  requires detail::solver_for_distributed<Solver>
vert_map<distributed<M>, double> heat_geodesics(distributed<M>& m,
                                                std::initializer_list<std::pair<vert_t<M>, double>> sources,
                                                const heat_geodesics_options& options = {}, Solver&& solver = {}) {
  return detail::distributed_heat_geodesics(m, sources, options, solver);
}

}  // namespace concino
