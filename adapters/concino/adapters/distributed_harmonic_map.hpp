// Harmonic maps on distributed meshes: harmonic_map(d, values).
// Needs: PETSc 3.18 with MPI (Debian: petsc-dev), and a petsc_session in main.
#pragma once

#include <concino/adapters/detail/distributed/distributed_problem.hpp>
#include <concino/adapters/detail/distributed/distributed_scale.hpp>
#include <concino/adapters/detail/distributed/distributed_system.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/petsc.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/operators/mass_matrix.hpp>

#include <Eigen/SparseCore>

#include <initializer_list>
#include <utility>
#include <vector>

namespace concino {

namespace detail {

/// The inverses of the lumped masses of the verts of this process, by row; their polys are all in the local mesh.
template<class M, class T>
std::vector<double> inverse_masses(const distributed_problem<M, T>& problem, int scale) {
  const distributed<M>& m = problem.mesh();
  const auto at = scaled_by(m.base(), scale);
  const auto mass = vert_masses(at);
  std::vector<double> r;
  // not 0: the Laplacian refuses polys without a measure
  for (const vert_t<M> v : problem.own()) r.push_back(1 / mass[v]);
  return r;
}

template<class T, class M, class V, class Solver>
vert_map<distributed<M>, T> distributed_harmonic_map(const distributed<M>& m, const V& values,
                                                     const harmonic_map_options& options, const Solver& solver) {
  on_all(m.communicator(), [&] { check_exponent(options.exponent, "harmonic_map"); });
  const distributed_problem<M, T> problem(m, values, "harmonic_map");
  const int scale = common_length_exponent(m);
  Eigen::SparseMatrix<double> a;
  std::vector<double> diagonal;
  on_all(m.communicator(), [&] {
    a = minus_laplacian(scaled_by(owned_part(m), scale), virtual_elements);
    if (options.exponent > 1) diagonal = inverse_masses(problem, scale);
  });
  const distributed_system<M, T> system(problem, a, solver.options(), options.exponent, diagonal);
  auto u = problem.prescribed(options.isolated_value);
  system.solve(problem.zeros(), u, solver);
  return u;
}

}  // namespace detail

/// harmonic_map of the whole mesh, which all its processes compute together. harmonic_map<vec3> maps to space,
/// coordinate by coordinate.
/// Needs:  a distributed mesh. values: pairs of a local vert and a number (or point); each process gives those of its
///         verts, and may repeat those of its ghosts. T: double or vec3. solver: a petsc, whose communicator is
///         replaced by that of the mesh. The options are the same on all processes.
/// Result: as harmonic_map of the mesh that was divided, at local verts, ghosts included. solver.iterations() and
///         solver.residual() describe the last solve. progress and profiler are not used.
/// Cost:   as that of one process divided by their number, and messages between neighbours in each iteration.
/// Errors: as harmonic_map; verts are named by their global numbers. Every error is thrown on all processes.
/// Source: as harmonic_map.
template<class T = double, class M, class V = std::initializer_list<std::pair<vert_t<M>, T>>, class Solver = petsc>
  requires detail::field_value<T> && detail::gives_values<V, vert_t<M>> && detail::solver_for_distributed<Solver>
vert_map<distributed<M>, T> harmonic_map(const distributed<M>& m, const V& values,
                                         const harmonic_map_options& options = {}, Solver&& solver = {}) {
  return detail::distributed_harmonic_map<T>(m, values, options, solver);
}
template<class T = double, class M, class V = std::initializer_list<std::pair<vert_t<M>, T>>, class Solver = petsc>
  requires detail::field_value<T> && detail::gives_values<V, vert_t<M>> && detail::solver_for_distributed<Solver>
vert_map<distributed<M>, T> harmonic_map(distributed<M>& m, const V& values, const harmonic_map_options& options = {},
                                         Solver&& solver = {}) {
  return detail::distributed_harmonic_map<T>(m, values, options, solver);
}

}  // namespace concino
