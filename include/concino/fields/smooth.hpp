// Smoothing of fields: a field near the input that varies less. Applied to the points it is implicit fairing.
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

template<class M>
struct smooth_options {
  std::vector<vert_t<M>> fixed = {};     // verts that keep their values
  int exponent = 1;                      // n >= 1: energy u . L (M^-1 L)^(n-1) u; 1: of the gradient (Dirichlet
                                         // energy), 2: of the Laplacian
  concino::progress progress = nullptr;  // called with "smoothing", "factorising", "solving"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

namespace detail {

template<class M, class D>
implicit_system<M> smoothing_system(const M& m, double amount, const D& discretisation,
                                    const smooth_options<M>& options) {
  const char* const caller = "smooth";
  if (!(amount >= 0 && std::isfinite(amount)))
    core::throw_joined<invalid_argument>(
        {caller, ": amount is ", core::number_text(amount), "; it must be finite and 0 or more"});
  if (options.exponent < 1)
    core::throw_joined<invalid_argument>(
        {caller, ": exponent is ", core::number_text(options.exponent), "; it must be 1 or more"});
  report_progress(options.progress, 0, "smoothing");
  constrained_verts<M> constrained(m);
  constrained.constrain(m, options.fixed, caller);
  return at_unit_size(m, discretisation, [&](const auto& at, int exponent) -> implicit_system<M> {
    auto mass = mass_beside(at, discretisation, true, caller);
    return {m,
            discretisation,
            std::move(constrained),
            std::move(mass),
            std::ldexp(amount, -2 * options.exponent * exponent),
            polyharmonic(at, discretisation, options.exponent, caller),
            caller};
  });
}

}  // namespace detail

/// A system prepared by prepare_smooth. Several threads may use it if the solver allows it. Copies share the prepared
/// data.
template<class M, class Solver>
class prepared_smooth {
  struct preparation {
    detail::implicit_system<M> system;
    std::unique_ptr<Solver> solver;
  };

  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const preparation> prepared_;

 public:
  template<class D>
  prepared_smooth(const M& m, double amount, const D& discretisation, const smooth_options<M>& input_options,
                  const Solver& solver)
      : mesh_(m) {
    const core::profiled_options profiled(input_options, "prepare_smooth");
    const smooth_options<M>& options = *profiled;
    auto system = detail::smoothing_system(m, amount, discretisation, options);
    auto own = detail::make_similar_solver(solver);
    system.factorize(*own, options.progress);
    prepared_ = std::make_shared<const preparation>(preparation{std::move(system), std::move(own)});
    detail::report_progress(options.progress, 1, "smoothing");
  }

  const M& mesh() const { return mesh_.get(); }
  const Solver& solver() const { return *prepared_->solver; }
  /// The number of verts without edges that are not fixed. They keep their values.
  std::size_t num_isolated() const { return prepared_->system.constrained().num_isolated; }

  /// The smoothed f.
  /// Needs:  f as for smooth; the mesh has not changed since it was prepared.
  /// Result: that of smooth.      Cost: one back-substitution, three for vectors.
  /// Errors: as smooth about f; solver_error.
  template<class F, class T = detail::field_value_of<F, M>>
    requires requirement::is_given_field<F, M>
  vert_map<M, T> apply(const F& f) const {
    const M& m = mesh_.get();
    auto u = prepared_->system.template values_of<T>(m, f);
    prepared_->system.template apply<T>(*prepared_->solver, u);
    return u;
  }
};

/// Prepares smoothing by a fixed amount, for many fields: auto s = prepare_smooth(m, amount); auto u = s.apply(f).
/// Needs:  as smooth; the mesh must not change afterwards. solver: the result keeps a solver of the same type,
///         constructed from its options() if it has them.
/// Result: an object with apply(f); num_isolated() is the number of verts without edges that are not fixed.
/// Cost:   as smooth without the back-substitution.
/// Errors: as smooth, except those about f.
template<class M, class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> &&
      SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_smooth<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_smooth(
              M&& m, double amount, const smooth_options<std::remove_cvref_t<M>>& options = {},
              Solver&& solver = auto_solver({.questions = 20})) {
    return {m, amount, virtual_elements, options, solver};
  }
template<class M, class D, class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && Discretisation<D, M> &&
      SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_smooth<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_smooth(
              M&& m, double amount, const D& discretisation, const smooth_options<std::remove_cvref_t<M>>& options = {},
              Solver&& solver = auto_solver({.questions = 20})) {
    return {m, amount, discretisation, options, solver};
  }

/// Smooths values on verts: minimises the sum of mass times |u - f|^2 plus amount times the energy of u. That is, it
/// solves (M + amount L') u = M f. L' is minus the Laplacian or, for exponent n, its power L' (M^-1 L')^(n-1). M is the
/// lumped mass, or that of the discretisation, which is passed after the amount; in smooth(m, f, amount, uniform) it is
/// the identity. The default is virtual_elements. Fixed verts keep their value.
/// Needs:  EmbeddedMesh M; with a Discretisation what that needs: with `uniform` any PrimalGraph. f: any readable map
///         over verts, or function of the point of a vert, of numbers, or of points for vectors, which are smoothed
///         component by component with one factorisation. amount: finite, 0 or more, in units of length^(2 exponent),
///         without unit with `uniform`. Features narrower than its (2 exponent)-th root disappear. solver as for
///         harmonic_map.
/// Result: a map of double or vec3. Constants do not change, nor does the sum of mass times value if nothing is fixed.
///         Verts without edges keep their values; prepare_smooth counts them. Edges of no poly do not count, unless the
///         discretisation gives them a weight, as uniform does. Where nothing is fixed on the boundary, u meets it with
///         slope 0, so linear functions bend there. With `uniform` and exponent 1, values stay between the extrema of
///         f. With other discretisations they do so if no weight is negative.
/// Cost:   one factorisation of a sparse matrix with as many unknowns as there are verts to solve for. On large meshes
///         the default solver iterates instead, in time proportional to their number.
/// Errors: invalid_argument if amount or exponent is out of its range, or f is not finite at a vert that has edges or
///         is fixed. invalid_mesh if a fixed vert is no vert of m, or if a vert is coupled with others and has no mass.
///         Those of `laplacian` with this discretisation. solver_error. cancelled.
/// Source: Whittaker 1923; of points: Desbrun, Meyer, Schroeder, Barr 1999, "Implicit fairing of irregular meshes using
///         diffusion and curvature flow".
template<class M, class F, class T = detail::field_value_of<F, M>, class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && requirement::is_given_field<F, M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, T> smooth(M&& m, const F& f, double amount,
                                const smooth_options<std::remove_cvref_t<M>>& options = {}, Solver&& solver = {}) {
    return smooth(m, f, amount, virtual_elements, options, solver);
  }
template<class M, class F, class T = detail::field_value_of<F, M>, class D, class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && Discretisation<D, M> && requirement::is_given_field<F, M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, T> smooth(M&& m, const F& f, double amount, const D& discretisation,
                                const smooth_options<std::remove_cvref_t<M>>& input_options = {},
                                Solver&& solver = {}) {
    const core::profiled_options profiled(input_options, "smooth");
    const smooth_options<std::remove_cvref_t<M>>& options = *profiled;
    const std::remove_cvref_t<M>& mesh_in = m;
    const auto system = detail::smoothing_system(mesh_in, amount, discretisation, options);
    auto u = system.template values_of<T>(mesh_in, f);
    system.factorize(solver, options.progress);
    detail::report_progress(options.progress, 0.9, "solving");
    system.template apply<T>(solver, u);
    detail::report_progress(options.progress, 1, "smoothing");
    return u;
  }

// What to write instead of calls that cannot compile.
template<class... T> void prepare_smooth(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void prepare_smooth(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_smooth(mistake::bare_graph<mistake::name_discretisation>, ...) = delete;  // needs point(m, v) and polys; else write prepare_smooth(m, amount, uniform)
template<class... T> void smooth(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void smooth(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void smooth(mistake::bare_graph<mistake::name_discretisation>, ...) = delete;  // needs point(m, v) and polys; else write smooth(m, f, amount, uniform)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_or_points_at_verts>>
  requires(PrimalGraph<M> && !requirement::is_given_field<U, M>)
void smooth(M&&, const U&, ...) = delete;  // a number or a point at each vert: make_vert_map<double>(m)

}  // namespace concino
