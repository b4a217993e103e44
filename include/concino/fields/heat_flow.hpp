// Heat flow: values at the verts diffuse over a surface or through a volume.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/fields/detail/problems/implicit.hpp>
#include <concino/fields/detail/problems/make_similar_solver.hpp>
#include <concino/fields/detail/problems/scaled_mesh.hpp>
#include <concino/solve/auto_solver.hpp>

#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

/// second_order:   two implicit stages with one matrix. The error decreases with the square of the step length. Sharp
/// differences decay in a
///                 few steps and do not oscillate on, although steps that are long for the mesh may overshoot them a
///                 little.
/// backward_euler: one stage, of the first order. With lumped masses and no negative weights the values stay within the
/// range of the previous ones.
enum class heat_scheme { second_order, backward_euler };

template<class M>
struct heat_flow_options {
  std::vector<vert_t<M>> fixed = {};      // verts that keep their values
  int steps = 10;                         // number of steps of equal length, 1 or more
  concino::heat_scheme scheme = concino::heat_scheme::second_order;  // how each step is computed
  bool lumped = false;                    // lumped masses: see backward_euler; otherwise the Galerkin mass, of second
                                          // order in the size of the polys
  concino::progress progress = nullptr;   // called with "heat flow", "factorising"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

namespace detail {

/// 1 - 1 / sqrt(2): with this value both stages have the same matrix and the scheme is L-stable.
inline constexpr double alexander_gamma = 0.29289321881345247560;

template<class M, class D>
implicit_system<M> heat_flow_system(const M& m, double time, const D& discretisation,
                                    const heat_flow_options<M>& options) {
  const char* const caller = "heat_flow";
  if (!(time >= 0 && std::isfinite(time)))
    core::throw_joined<invalid_argument>(
        {caller, ": time is ", core::number_text(time), "; it must be finite and 0 or more"});
  if (options.steps < 1)
    core::throw_joined<invalid_argument>(
        {caller, ": steps is ", core::number_text(options.steps), "; it must be 1 or more"});
  report_progress(options.progress, 0, "heat flow");
  constrained_verts<M> constrained(m);
  constrained.constrain(m, options.fixed, caller);
  const double step = (options.scheme == heat_scheme::second_order ? alexander_gamma : 1) * (time / options.steps);
  return at_unit_size(m, discretisation, [&](const auto& at, int exponent) -> implicit_system<M> {
    auto mass = mass_beside(at, discretisation, options.lumped, caller);
    return {m,
            discretisation,
            std::move(constrained),
            std::move(mass),
            std::ldexp(step, -2 * exponent),
            minus_laplacian(at, discretisation),
            caller};
  });
}

/// Steps of M u' = -K u. With A = M + g dt K, the stages are A v = M u and A w = M u - (1 - g) dt K v. Here dt K v = M
/// (u - v) / g, so only A^-1 M is needed; w is u one step later.
template<class T, class M, class Solver>
void flow(const implicit_system<M>& system, const Solver& solver, const heat_flow_options<M>& options,
          vert_map<M, T>& u, const progress& on_progress) {
  constexpr double forward = (1 - alexander_gamma) / alexander_gamma;
  for (int i = 0; i < options.steps; ++i) {
    report_progress(on_progress, static_cast<double>(i) / options.steps, "heat flow");
    if (options.scheme == heat_scheme::second_order) {
      vert_map<M, T> stage = u;
      system.template apply<T>(solver, stage);
      const auto from = stage.values(), to = u.values();
      for (const int index : system.constrained().index) {
        const auto k = static_cast<std::size_t>(index);
        to[k] = to[k] + forward * (from[k] - to[k]);
      }
    }
    system.template apply<T>(solver, u);
  }
  report_progress(on_progress, 1, "heat flow");
}

}  // namespace detail

/// A system prepared by prepare_heat_flow. Several threads may use it if the solver allows it. Copies share the
/// prepared data.
template<class M, class Solver>
class prepared_heat_flow {
  struct preparation {
    detail::implicit_system<M> system;
    std::unique_ptr<Solver> solver;
    heat_flow_options<M> options;
    double time;
  };

  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const preparation> prepared_;

 public:
  template<class D>
  prepared_heat_flow(const M& m, double time, const D& discretisation, const heat_flow_options<M>& input_options,
                     const Solver& solver)
      : mesh_(m) {
    const core::profiled_options profiled(input_options, "prepare_heat_flow");
    const heat_flow_options<M>& options = *profiled;
    auto system = detail::heat_flow_system(m, time, discretisation, options);
    auto own = detail::make_similar_solver(solver);
    system.factorize(*own, options.progress);
    preparation p{std::move(system), std::move(own), options, time};
    p.options.progress = nullptr;  // the caller's callable may no longer exist by then
    prepared_ = std::make_shared<const preparation>(std::move(p));
    detail::report_progress(options.progress, 1, "heat flow");
  }

  const M& mesh() const { return mesh_.get(); }
  const Solver& solver() const { return *prepared_->solver; }
  /// The time over which heat flows.
  double time() const { return prepared_->time; }
  /// The number of verts without edges that are not fixed. They keep their values.
  std::size_t num_isolated() const { return prepared_->system.constrained().num_isolated; }

  /// The values u after the prepared time. To continue, call it again with the result.
  /// Needs:  u as for heat_flow; the mesh has not changed since it was prepared.
  /// Result: that of heat_flow.      Cost: two back-substitutions per step, or one, see heat_scheme; three times that
  ///         for vectors.
  /// Errors: as heat_flow about u; solver_error; cancelled.
  template<class F, class T = detail::field_value_of<F, M>>
    requires requirement::is_given_field<F, M>
  vert_map<M, T> advance(const F& u, const progress& on_progress = nullptr) const {
    const M& m = mesh_.get();
    auto r = prepared_->system.template values_of<T>(m, u);
    detail::flow<T>(prepared_->system, *prepared_->solver, prepared_->options, r, on_progress);
    return r;
  }
};

/// Prepares heat flow over a given time, for many fields or for repeated use on one: auto h = prepare_heat_flow(m,
/// time); u = h.advance(u).
/// Needs:  as heat_flow; the mesh must not change afterwards. solver: the result keeps a solver of the same type,
///         constructed from its options() if it has them.
/// Result: an object with advance(u); num_isolated() is the number of verts without edges that are not fixed.
/// Cost:   as heat_flow without the steps.
/// Errors: as heat_flow, except those about values.
template<class M, class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> &&
      SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_heat_flow<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_heat_flow(
              M&& m, double time, const heat_flow_options<std::remove_cvref_t<M>>& options = {},
              Solver&& solver = auto_solver({.questions = 20})) {
    return {m, time, virtual_elements, options, solver};
  }
template<class M, class D, class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && Discretisation<D, M> &&
      SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_heat_flow<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_heat_flow(
              M&& m, double time, const D& discretisation,
              const heat_flow_options<std::remove_cvref_t<M>>& options = {},
              Solver&& solver = auto_solver({.questions = 20})) {
    return {m, time, discretisation, options, solver};
  }

/// Solves the heat equation u_t = Laplacian of u: returns the values at `time`, starting from `initial` at time 0. The
/// Laplacian is that of the discretisation, which is passed after the time; the default is virtual_elements. Fixed
/// verts keep their values. No heat flows through the boundary where no verts are fixed.
/// Needs:  EmbeddedMesh M; with a Discretisation what that needs: with `uniform` any PrimalGraph. initial: any readable
///         map over verts, or function of the point of a vert, of numbers, or of points for vectors, whose components
///         flow independently. time: finite, 0 or more, in units of length^2; without unit with `uniform`, where M is
///         the identity. solver as for harmonic_map.
/// Result: a map of double or vec3. If nothing is fixed, the total heat (the sum of M u) is constant, and the sum of u
///         times M u never grows. The limit for long times is then the mean value in each component; with fixed values
///         it is the harmonic map through them. Verts without edges keep their value; prepare_heat_flow counts them.
///         Edges of no poly do not count, unless the discretisation gives them a weight, as uniform does.
/// Cost:   one factorisation of a sparse matrix with as many unknowns as there are verts to solve for, and two
///         back-substitutions per step, or one, see heat_scheme. On large meshes the default solver iterates for the
///         first ones, in time proportional to the number of unknowns.
/// Errors: invalid_argument if time or steps is out of its range, or a value is not finite at a vert that has edges or
///         is fixed. invalid_mesh if a fixed vert is no vert of m, or if a vert is coupled with others and has no mass.
///         Those of `laplacian` with this discretisation and of mass_matrix. solver_error. cancelled.
/// Source: Alexander 1977, "Diagonally implicit Runge-Kutta methods for stiff O.D.E.'s" (the scheme of two stages).
template<class M, class F, class T = detail::field_value_of<F, M>, class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && requirement::is_given_field<F, M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, T> heat_flow(M&& m, const F& initial, double time,
                                   const heat_flow_options<std::remove_cvref_t<M>>& options = {},
                                   Solver&& solver = {}) {
    return heat_flow(m, initial, time, virtual_elements, options, solver);
  }
template<class M, class F, class T = detail::field_value_of<F, M>, class D, class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && Discretisation<D, M> && requirement::is_given_field<F, M> &&
           SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, T> heat_flow(M&& m, const F& initial, double time, const D& discretisation,
                         const heat_flow_options<std::remove_cvref_t<M>>& input_options = {}, Solver&& solver = {}) {
  const core::profiled_options profiled(input_options, "heat_flow");
  const heat_flow_options<std::remove_cvref_t<M>>& options = *profiled;
  const std::remove_cvref_t<M>& mesh_in = m;
  const auto system = detail::heat_flow_system(mesh_in, time, discretisation, options);
  auto u = system.template values_of<T>(mesh_in, initial);
  system.factorize(solver, options.progress);
  detail::flow<T>(system, solver, options, u, options.progress);
  return u;
}

// What to write instead of calls that cannot compile.
template<class... T> void prepare_heat_flow(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void prepare_heat_flow(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_heat_flow(mistake::bare_graph<mistake::name_discretisation>, ...) = delete;  // needs point(m, v) and polys; else write prepare_heat_flow(m, time, uniform)
template<class... T> void heat_flow(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void heat_flow(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void heat_flow(mistake::bare_graph<mistake::name_discretisation>, ...) = delete;  // needs point(m, v) and polys; else write heat_flow(m, initial, time, uniform)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_or_points_at_verts>>
  requires(PrimalGraph<M> && !requirement::is_given_field<U, M>)
void heat_flow(M&&, const U&, ...) = delete;  // a number or a point at each vert: make_vert_map<double>(m)

}  // namespace concino
