// Poisson's equation on distributed meshes: poisson(d, f, {.values = ...}).
// Needs: PETSc 3.18 with MPI (Debian: petsc-dev), and a petsc_session in main.
#pragma once

#include <concino/adapters/detail/distributed/distributed_problem.hpp>
#include <concino/adapters/detail/distributed/distributed_system.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/petsc.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino {

namespace detail {

template<class M, class F, class Solver>
vert_map<distributed<M>, double> distributed_poisson(const distributed<M>& m, const F& f,
                                                     const poisson_options<distributed<M>>& options,
                                                     const Solver& solver) {
  on_all(m.communicator(), [&] {
    if (!options.fluxes.empty()) throw unsupported("poisson: on distributed meshes there are no fluxes");
  });
  const distributed_problem<M> problem(m, options.values, "poisson");
  Eigen::SparseMatrix<double> a;
  std::vector<double> load = problem.zeros();
  on_all(m.communicator(), [&] {
    const auto part = owned_part(m);
    a = -laplacian(part);
    const Eigen::SparseMatrix<double> mass = mass_matrix(part, {.lumped = false});
    std::vector<double> of(load.size(), 0.0);
    for (const vert_t<M> v : verts(part)) {
      const std::size_t i = index_of(part, v);
      of[i] = static_cast<double>(f[v]);
      if (!std::isfinite(of[i]))
        core::throw_joined<invalid_argument>({"poisson: the load f at vert ", m.global_number(v), " is not finite"});
    }
    for (int c = 0; c < mass.outerSize(); ++c)
      for (Eigen::SparseMatrix<double>::InnerIterator e(mass, c); e; ++e)
        load[static_cast<std::size_t>(e.row())] += e.value() * of[static_cast<std::size_t>(c)];
  });
  const distributed_system<M> system(problem, std::move(a), solver.options());
  auto u = problem.prescribed(options.isolated_value);
  system.solve(std::move(load), u, solver);
  return u;
}

}  // namespace detail

/// poisson of the whole mesh, which all its processes compute together.
/// Needs:  a distributed mesh. f[v] is a number for each vert of the polys of this process, the same on all processes
///         that share the vert. options.values: as for harmonic_map of distributed meshes. solver: a petsc, whose
///         communicator is replaced by that of the mesh.
/// Result: as poisson of the mesh that was divided, at local verts, ghosts included. solver.iterations() and
///         solver.residual() describe the solve. progress and profiler are not used.
/// Cost:   as that of one process divided by their number, and messages between neighbours in each iteration.
/// Errors: as poisson; verts are named by their global numbers. unsupported if fluxes are given. Every error is thrown
///         on all processes.
/// Source: as poisson.
template<class M, class F, class Solver = petsc>
  requires detail::solver_for_distributed<Solver> vert_map < distributed<M>,
double > poisson(const distributed<M>& m, const F& f, const poisson_options<distributed<M>>& options = {},
                 Solver&& solver = {}) {
  return detail::distributed_poisson(m, f, options, solver);
}
template<class M, class F, class Solver = petsc>
  requires detail::solver_for_distributed<Solver> vert_map < distributed<M>,
double >
    poisson(distributed<M>& m, const F& f, const poisson_options<distributed<M>>& options = {}, Solver&& solver = {}) {
  return detail::distributed_poisson(m, f, options, solver);
}

}  // namespace concino
