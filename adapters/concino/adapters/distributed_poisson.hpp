// Poisson's equation on distributed meshes: poisson(d, f, {.values = ..., .fluxes = ...}).
// Needs: PETSc 3.18 with MPI (Debian: petsc-dev), and a petsc_session in main.
#pragma once

#include <concino/adapters/detail/distributed/distributed_problem.hpp>
#include <concino/adapters/detail/distributed/distributed_scale.hpp>
#include <concino/adapters/detail/distributed/distributed_system.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/petsc.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/operators/mass_matrix.hpp>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace concino {

namespace detail {

/// Errors: invalid_argument if the load is not finite at a vert of the polys of this process.
template<class T, class M, class F>
void check_load(const distributed<M>& m, const F& f) {
  const auto part = owned_part(m);
  for (const vert_t<M> v : verts(part)) {
    const T x = as_field_value<T>(value_at(m, f, v));
    for (std::size_t k = 0; k < component_count<T>; ++k)
      if (!std::isfinite(field_component(x, k)))
        core::throw_joined<invalid_argument>({"poisson: the load f at vert ", m.global_number(v), " is not finite"});
  }
}

/// The fluxes at facets of the polys of this process. All polys of these facets are in the local mesh.
/// Errors: invalid_mesh if one is given at what is no local facet.
template<class M, class T>
std::vector<std::pair<facet_t<M>, T>> own_fluxes(const distributed<M>& m,
                                                 const std::vector<std::pair<facet_t<M>, T>>& fluxes) {
  std::vector<std::pair<facet_t<M>, T>> r;
  for (const auto& [x, flux] : fluxes) {
    if (!contains(m.base(), x))
      throw invalid_mesh("poisson: a flux is given at what is no edge or face of this process");
    bool is_own = false;
    for (const poly_t<M> p : adj_facet2p(m.base(), x)) is_own = is_own || !m.is_ghost(p);
    if (is_own) r.emplace_back(x, flux);
  }
  return r;
}

/// An edge or face by the global numbers of its verts.
template<class M>
std::string name_of_facet(const distributed<M>& m, const facet_t<M>& x) {
  std::string r = dimension_v<M> == 2 ? "the edge of verts" : "the face of verts";
  const char* separator = " ";
  for (const vert_t<M> v : adj_facet2v(m.base(), x)) {
    r += core::joined({separator, m.global_number(v)});
    separator = ", ";
  }
  return r;
}

template<class T, class M, class F, class Solver>
vert_map<distributed<M>, T> distributed_poisson(const distributed<M>& m, const F& f,
                                                const poisson_options<distributed<M>, T>& options,
                                                const Solver& solver) {
  const distributed_problem<M, T> problem(m, options.values, "poisson");
  const int scale = common_length_exponent(m);
  Eigen::SparseMatrix<double> a;
  std::vector<T> load = problem.zeros();
  on_all(m.communicator(), [&] {
    const auto part = owned_part(m);
    const auto at = scaled_by(part, scale);
    a = minus_laplacian(at, virtual_elements);
    const Eigen::SparseMatrix<double> mass = mass_matrix(at, {.lumped = false});
    check_load<T>(m, f);
    const auto sum = poisson_load<T>(scaled_by(m.base(), scale), mass_times<T>(part, mass, f, "poisson: the load f"),
                                     own_fluxes(m, options.fluxes), "poisson",
                                     [&](const auto&, const facet_t<M>& x) { return name_of_facet(m, x); });
    for (std::size_t i = 0; i < load.size(); ++i)
      for (std::size_t k = 0; k < component_count<T>; ++k)
        field_component(load[i], k) = sum[k][static_cast<Eigen::Index>(i)];
  });
  const distributed_system<M, T> system(problem, a, solver.options());
  auto u = problem.prescribed(options.isolated_value);
  system.solve(std::move(load), u, solver);
  return u;
}

}  // namespace detail

/// poisson of the whole mesh, which all its processes compute together.
/// Needs:  a distributed mesh. f: as for poisson, at each vert of the polys of this process, the same on all processes
///         that share the vert. options.values: as for harmonic_map of distributed meshes. options.fluxes: each process
///         gives those at edges (faces of volumes) of its polys; those at facets of ghosts alone are not used. solver:
///         a petsc, whose communicator is replaced by that of the mesh.
/// Result: as poisson of the mesh that was divided, at local verts, ghosts included. solver.iterations() and
///         solver.residual() describe the last solve. progress and profiler are not used.
/// Cost:   as that of one process divided by their number, and messages between neighbours in each iteration.
/// Errors: as poisson; verts are named by their global numbers, edges and faces by those of their verts. Every error is
///         thrown on all processes.
/// Source: as poisson.
template<class M, class F, class T = detail::field_value_of<F, distributed<M>>, class Solver = petsc>
  requires detail::solver_for_distributed<Solver>
vert_map<distributed<M>, T> poisson(
    const distributed<M>& m, const F& f,
    const poisson_options<distributed<M>, detail::field_value_of<F, distributed<M>>>& options = {},
    Solver&& solver = {}) {
  return detail::distributed_poisson<T>(m, f, options, solver);
}
template<class M, class F, class T = detail::field_value_of<F, distributed<M>>, class Solver = petsc>
  requires detail::solver_for_distributed<Solver>
vert_map<distributed<M>, T> poisson(
    distributed<M>& m, const F& f,
    const poisson_options<distributed<M>, detail::field_value_of<F, distributed<M>>>& options = {},
    Solver&& solver = {}) {
  return detail::distributed_poisson<T>(m, f, options, solver);
}

}  // namespace concino
