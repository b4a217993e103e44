// Heat flow on distributed meshes: heat_flow(d, u, time).
// Needs: PETSc 3.18 with MPI (Debian: petsc-dev), and a petsc_session in main.
#pragma once

#include <concino/adapters/detail/distributed/distributed_problem.hpp>
#include <concino/adapters/detail/distributed/distributed_scale.hpp>
#include <concino/adapters/detail/distributed/distributed_system.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/petsc.hpp>
#include <concino/core/number_text.hpp>
#include <concino/fields/heat_flow.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino {

namespace detail {

template<class M>
void check_heat_flow_options(double time, const heat_flow_options<distributed<M>>& options) {
  if (!(time >= 0 && std::isfinite(time)))
    core::throw_joined<invalid_argument>(
        {"heat_flow: time is ", core::number_text(time), "; it must be finite and 0 or more"});
  if (options.steps < 1)
    core::throw_joined<invalid_argument>({"heat_flow: steps is ", options.steps, "; it must be 1 or more"});
}

/// The field at the local verts, from those that own them.
template<class T, class M, class F>
vert_map<distributed<M>, T> initial_heat(const distributed<M>& m, const F& f) {
  auto u = make_vert_map<T>(m);
  on_all(m.communicator(), [&] {
    for (const vert_t<M> v : verts(m)) {
      u[v] = as_field_value<T>(value_at(m, f, v));
      if (m.is_ghost(v) || num_elements(adj_v2p(m, v)) == 0) continue;
      for (std::size_t k = 0; k < component_count<T>; ++k)
        if (!std::isfinite(field_component(u[v], k)))
          core::throw_joined<invalid_argument>(
              {"heat_flow: the initial value at vert ", m.global_number(v), " is not finite"});
    }
  });
  exchange_ghosts(u);
  return u;
}

template<class T, class M, class F>
vert_map<distributed<M>, T> distributed_heat_flow(const distributed<M>& m, const F& f, double time,
                                                  const heat_flow_options<distributed<M>>& options,
                                                  const petsc& solver) {
  on_all(m.communicator(), [&] { check_heat_flow_options<M>(time, options); });
  auto u = initial_heat<T>(m, f);
  std::vector<std::pair<vert_t<M>, T>> fixed;
  on_all(m.communicator(), [&] {
    for (const vert_t<M>& v : options.fixed) {
      if (!contains(m, v)) throw invalid_mesh("heat_flow: what is fixed is no vert of this process");
      fixed.emplace_back(v, u[v]);
    }
  });
  const distributed_problem<M, T> problem(m, fixed, "heat_flow", true);
  const int scale = common_length_exponent(m);
  const bool is_second_order = options.scheme == heat_scheme::second_order;
  const double step = std::ldexp((is_second_order ? alexander_gamma : 1) * (time / options.steps), -2 * scale);
  Eigen::SparseMatrix<double> mass, a;
  on_all(m.communicator(), [&] {
    const auto part = scaled_by(owned_part(m), scale);
    mass = mass_matrix(part, {.lumped = options.lumped});
    a = mass - step * laplacian(part);
  });
  const distributed_system<M, T> system(problem, a, solver.options());
  const auto apply = [&](vert_map<distributed<M>, T>& x) {  // A^-1 M
    std::vector<T> load = problem.zeros();
    for (int c = 0; c < mass.outerSize(); ++c)
      for (Eigen::SparseMatrix<double>::InnerIterator e(mass, c); e; ++e)
        load[static_cast<std::size_t>(e.row())] += e.value() * x.data()[c];
    system.solve(std::move(load), x, solver);
  };
  constexpr double forward = (1 - alexander_gamma) / alexander_gamma;
  for (int i = 0; i < options.steps; ++i) {  // the stages of heat_flow of one process
    if (is_second_order) {
      auto stage = u;
      apply(stage);
      for (const vert_t<M> v : verts(m))
        if (problem.is_unknown(index_of(m, v))) u[v] += forward * (stage[v] - u[v]);
    }
    apply(u);
  }
  return u;
}

}  // namespace detail

/// heat_flow of the whole mesh, which all its processes compute together.
/// Needs:  a distributed mesh. f: as for heat_flow, at each local vert; values of ghosts are not used. options.fixed:
///         local verts; each process gives those of its verts, and may repeat those of its ghosts. solver: a petsc,
///         whose communicator is replaced by that of the mesh.
/// Result: as heat_flow of the mesh that was divided, at local verts, ghosts included. solver.iterations() and
///         solver.residual() describe the last solve. progress and profiler are not used.
/// Cost:   as that of one process divided by their number, and messages between neighbours in each iteration.
/// Errors: as heat_flow; verts are named by their global numbers. Every error is thrown on all processes.
/// Source: as heat_flow.
template<class M, class F, class T = detail::field_value_of<F, distributed<M>>, class Solver = petsc>
  requires detail::solver_for_distributed<Solver>
vert_map<distributed<M>, T> heat_flow(const distributed<M>& m, const F& f, double time,
                                      const heat_flow_options<distributed<M>>& options = {}, Solver&& solver = {}) {
  return detail::distributed_heat_flow<T>(m, f, time, options, solver);
}
template<class M, class F, class T = detail::field_value_of<F, distributed<M>>, class Solver = petsc>
  requires detail::solver_for_distributed<Solver>
vert_map<distributed<M>, T> heat_flow(distributed<M>& m, const F& f, double time,
                                      const heat_flow_options<distributed<M>>& options = {}, Solver&& solver = {}) {
  return detail::distributed_heat_flow<T>(m, f, time, options, solver);
}

}  // namespace concino
