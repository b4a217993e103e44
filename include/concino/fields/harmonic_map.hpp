// Harmonic maps: the smoothest function with prescribed values at some verts. The paper's example, on any mesh.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/fields/detail/problems/dirichlet.hpp>
#include <concino/fields/detail/problems/laplace_system.hpp>
#include <concino/fields/detail/problems/make_similar_solver.hpp>
#include <concino/solve/auto_solver.hpp>

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>

namespace concino {

struct harmonic_map_options {
  int exponent = 1;                      // n >= 1: L (M^-1 L)^(n-1) u = 0; 1: harmonic, 2: biharmonic, ...
  double isolated_value = 0;             // at verts without edges and without a prescribed value, in each component;
                                         // any number, NaN too
  concino::progress progress = nullptr;  // called with "harmonic map", "factorising", "solving"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

namespace detail {

inline void check_exponent(int exponent, const char* caller) {
  if (exponent < 1)
    core::throw_joined<invalid_argument>(
        {caller, ": exponent is ", core::number_text(exponent), "; it must be 1 or more"});
}

/// The unknowns and their system, with prescribed values at some verts. Shared by harmonic_map and
/// prepare_harmonic_map.
template<class M>
class harmonic_problem {
  static constexpr const char* caller = "harmonic_map";
  constrained_system<M> system_;
  double isolated_value_;

  template<class V, class D>
  static constrained_system<M> make_system(const M& m, const V& fixed, const D& discretisation,
                                           const harmonic_map_options& options) {
    check_exponent(options.exponent, caller);
    report_progress(options.progress, 0, "harmonic map");
    constrained_verts<M> constrained(m);
    constrained.constrain(m, fixed, caller);
    return harmonic_system(m, std::move(constrained), discretisation, options.exponent, caller);
  }

 public:
  /// fixed: verts, or pairs of a vert and a value.
  template<class V, class D>
  harmonic_problem(const M& m, const V& fixed, const D& discretisation, const harmonic_map_options& options)
      : system_(make_system(m, fixed, discretisation, options)), isolated_value_(options.isolated_value) {}

  std::size_t num_isolated() const { return system_.verts.num_isolated; }

  template<class Solver>
  void factorize(Solver& solver, const progress& on_progress) const { system_.factorize(solver, on_progress, caller); }

  /// A map with these values at their verts, and isolated_value elsewhere.
  template<class T, class V>
  vert_map<M, T> prescribe(const M& m, const V& values) const {
    return prescribed_values<T>(m, system_.verts, values, isolated_value_, caller);
  }
  /// Computes the unknown values of that map.
  template<class T, class Solver>
  void solve(const Solver& solver, vert_map<M, T>& u) const {
    system_.template solve<T>(solver, [](std::size_t, int) { return 0.0; }, u, caller);
  }
};

}  // namespace detail

/// A system prepared by prepare_harmonic_map. Several threads may use it if the solver allows it. Copies share the
/// prepared data.
template<class M, class Solver>
class prepared_harmonic_map {
  struct preparation {
    detail::harmonic_problem<M> problem;
    std::unique_ptr<Solver> solver;
  };

  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const preparation> prepared_;

 public:
  template<class V, class D>
  prepared_harmonic_map(const M& m, const V& fixed, const D& discretisation, const harmonic_map_options& input_options,
                        const Solver& solver)
      : mesh_(m) {
    const core::profiled_options profiled(input_options, "prepare_harmonic_map");
    const harmonic_map_options& options = *profiled;
    auto own = detail::make_similar_solver(solver);
    detail::harmonic_problem<M> problem(m, fixed, discretisation, options);
    problem.factorize(*own, options.progress);
    prepared_ = std::make_shared<const preparation>(preparation{std::move(problem), std::move(own)});
    detail::report_progress(options.progress, 1, "harmonic map");
  }

  const M& mesh() const { return mesh_.get(); }
  const Solver& solver() const { return *prepared_->solver; }
  /// The number of verts without edges and without a prescribed value. They get isolated_value.
  std::size_t num_isolated() const { return prepared_->problem.num_isolated(); }

  /// The harmonic map with these values at the constrained verts. with_values<vec3> maps to space, coordinate by
  /// coordinate.
  /// Needs:  pairs of a vert and a value, in braces or any container: at least one for each constrained vert and none
  ///         elsewhere. The mesh has not changed since it was prepared.
  /// Result: that of harmonic_map with these values.
  /// Cost:   one back-substitution; three for a map to space.
  /// Errors: invalid_argument if a value is not finite, a vert gets two different values or none, or a vert with a
  ///         value is not constrained; invalid_mesh if it is not a vert of the mesh; solver_error.
  template<class T = double, class D = std::initializer_list<std::pair<vert_t<M>, T>>>
    requires detail::field_value<T> && detail::gives_values<D, vert_t<M>>
  vert_map<M, T> with_values(const D& values) const {
    auto u = prepared_->problem.template prescribe<T>(mesh_.get(), values);
    prepared_->problem.template solve<T>(*prepared_->solver, u);
    return u;
  }
  template<class... T>
  void with_values(mistake::number<mistake::name_the_element>, ...) const = delete;  // elements have types: vert_id{0}, not 0
};

/// Prepares harmonic maps with prescribed values at the same verts, for many queries: auto h = prepare_harmonic_map(m,
/// {a, b}); auto u = h.with_values({{a, 0.0}, {b, 1.0}}).
/// Needs:  as harmonic_map; the mesh must not change afterwards. `fixed`: verts in braces or any container. solver: the
///         result keeps a solver of the same type, constructed from its options() if it has them.
/// Result: an object with with_values(...); num_isolated() is the number of verts that get isolated_value.
/// Cost:   that of harmonic_map without the back-substitution.
/// Errors: as harmonic_map, except those about values; invalid_mesh if a vert of `fixed` is no vert of m.
template<class M, class V = std::initializer_list<vert_t<M>>, class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && detail::names_elements<V, vert_t<M>> &&
      SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_harmonic_map<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_harmonic_map(
              M&& m, const V& fixed, const harmonic_map_options& options = {},
              Solver&& solver = auto_solver({.questions = 20})) {
    return {m, fixed, virtual_elements, options, solver};
  }
template<class M, class V = std::initializer_list<vert_t<M>>, class D, class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && Discretisation<D, M> && detail::names_elements<V, vert_t<M>> &&
      SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_harmonic_map<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_harmonic_map(
              M&& m, const V& fixed, const D& discretisation, const harmonic_map_options& options = {},
              Solver&& solver = auto_solver({.questions = 20})) {
    return {m, fixed, discretisation, options, solver};
  }

/// The function u on the verts that has the prescribed values and is harmonic everywhere else: L u = 0. With exponent n
/// it is polyharmonic: L (M^-1 L)^(n-1) u = 0. L is the Laplacian and M the mass matrix of the discretisation, which is
/// passed after the values: harmonic_map(m, values, uniform). The default is virtual_elements. harmonic_map<vec3> maps
/// to space, coordinate by coordinate.
/// Needs:  EmbeddedMesh M; with a Discretisation what that needs: with `uniform` any PrimalGraph. `values`: verts and
///         numbers (or points), in braces ({{a, 0.0}, {b, 1.0}}) or any container of pairs. A vert may be listed twice
///         with the same value. T: double or vec3. solver: a SparseSolver for symmetric positive definite matrices. The
///         default factorises small meshes, and iterates on large ones: see auto_solver. To learn what it did, pass one
///         that has a name.
/// Result: a map of T, u[v]. Prescribed values are exact. Verts without edges get isolated_value unless a value is
///         prescribed; prepare_harmonic_map counts them. Edges of no poly do not count, unless the discretisation gives
///         them a weight, as uniform does. With virtual_elements, linear functions on planar surfaces and on volumes
///         are harmonic, whatever the polys. With uniform and exponent 1, every value lies between the extrema of the
///         prescribed values in its component.
/// Cost:   one factorisation of a sparse matrix with as many unknowns as there are verts to solve for. On large meshes
///         the default solver iterates instead, in time proportional to their number.
/// Errors: invalid_mesh if a value is prescribed at what is no vert of m, or if exponent > 1 and a vert is coupled with
///         others and has no mass. invalid_argument if a value is not finite, a vert gets two different values, or
///         exponent < 1. solver_error if a component that has edges has no prescribed value (the message names one of
///         its verts), or if the system cannot be solved in double precision. Those of `laplacian` with this
///         discretisation. cancelled.
/// Source: Tutte 1963, Pinkall, Polthier 1993, Botsch, Kobbelt 2004 (higher exponents); paper section 3.
template<class T = double, class M, class V = std::initializer_list<std::pair<vert_t<M>, T>>,
         class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && detail::field_value<T> &&
      detail::gives_values<V, vert_t<M>> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, T> harmonic_map(M&& m, const V& values, const harmonic_map_options& options = {},
                                      Solver&& solver = {}) {
    return harmonic_map<T>(m, values, virtual_elements, options, solver);
  }
template<class T = double, class M, class V = std::initializer_list<std::pair<vert_t<M>, T>>, class D,
         class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && Discretisation<D, M> && detail::field_value<T> &&
      detail::gives_values<V, vert_t<M>> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, T> harmonic_map(M&& m, const V& values, const D& discretisation,
                                      const harmonic_map_options& input_options = {}, Solver&& solver = {}) {
    const core::profiled_options profiled(input_options, "harmonic_map");
    const harmonic_map_options& options = *profiled;
    const std::remove_cvref_t<M>& mesh_in = m;
    const detail::harmonic_problem<std::remove_cvref_t<M>> problem(mesh_in, values, discretisation, options);
    auto u = problem.template prescribe<T>(mesh_in, values);
    problem.factorize(solver, options.progress);
    detail::report_progress(options.progress, 0.9, "solving");
    problem.template solve<T>(solver, u);
    detail::report_progress(options.progress, 1, "harmonic map");
    return u;
  }

// What to write instead of calls that cannot compile.
template<class... T> void prepare_harmonic_map(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void prepare_harmonic_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_harmonic_map(mistake::bare_graph<mistake::name_discretisation>, ...) = delete;  // needs point(m, v) and polys; else write prepare_harmonic_map(m, verts, uniform)
template<class... T> void prepare_harmonic_map(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void harmonic_map(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void harmonic_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void harmonic_map(mistake::bare_graph<mistake::name_discretisation>, ...) = delete;  // needs point(m, v) and polys; else write harmonic_map(m, values, uniform)
template<class... T> void harmonic_map(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino
