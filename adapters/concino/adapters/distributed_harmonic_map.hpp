// Harmonic maps on distributed meshes: harmonic_map(d, values).
// Needs: PETSc 3.18 with MPI (Debian: petsc-dev), and a petsc_session in main.
#pragma once

#include <concino/adapters/detail/distributed/distributed_problem.hpp>
#include <concino/adapters/detail/distributed/distributed_system.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/petsc.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/operators/laplacian.hpp>

#include <Eigen/SparseCore>

#include <initializer_list>
#include <utility>

namespace concino {

namespace detail {

template<class M, class V, class Solver>
vert_map<distributed<M>, double> distributed_harmonic_map(const distributed<M>& m, const V& values,
                                                          const harmonic_map_options& options, const Solver& solver) {
  on_all(m.communicator(), [&] {
    if (options.exponent != 1) throw unsupported("harmonic_map: on distributed meshes the exponent is 1");
  });
  const distributed_problem<M> problem(m, values, "harmonic_map");
  Eigen::SparseMatrix<double> a;
  on_all(m.communicator(), [&] { a = -laplacian(owned_part(m)); });
  const distributed_system<M> system(problem, std::move(a), solver.options());
  auto u = problem.prescribed(options.isolated_value);
  system.solve(problem.zeros(), u, solver);
  return u;
}

}  // namespace detail

/// harmonic_map of the whole mesh, which all its processes compute together.
/// Needs:  a distributed mesh. values: pairs of a local vert and a number; each process gives those of its verts, and
///         may repeat those of its ghosts. Pairs of vert_t<M>{} are left out, so that d.vert(number) may be given.
///         solver: a petsc, whose communicator is replaced by that of the mesh.
/// Result: as harmonic_map of the mesh that was divided, at local verts, ghosts included. solver.iterations() and
///         solver.residual() describe the solve. options.exponent is 1; progress and profiler are not used.
/// Cost:   as that of one process divided by their number, and messages between neighbours in each iteration.
/// Errors: as harmonic_map; verts are named by their global numbers. unsupported for another exponent. Every error is
///         thrown on all processes.
/// Source: as harmonic_map.
template<class M, class V = std::initializer_list<std::pair<vert_t<M>, double>>, class Solver = petsc>
  requires detail::solver_for_distributed<Solver> vert_map < distributed<M>,
double > harmonic_map(const distributed<M>& m, const V& values, const harmonic_map_options& options = {},
                      Solver&& solver = {}) {
  return detail::distributed_harmonic_map(m, values, options, solver);
}
template<class M, class V = std::initializer_list<std::pair<vert_t<M>, double>>, class Solver = petsc>
  requires detail::solver_for_distributed<Solver> vert_map < distributed<M>,
double >
    harmonic_map(distributed<M>& m, const V& values, const harmonic_map_options& options = {}, Solver&& solver = {}) {
  return detail::distributed_harmonic_map(m, values, options, solver);
}

}  // namespace concino
