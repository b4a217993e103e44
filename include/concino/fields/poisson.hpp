// Poisson's equation: the function with a prescribed Laplacian, and with prescribed values and derivatives on the
// boundary. On any mesh.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/fields/detail/problems/dirichlet.hpp>
#include <concino/fields/detail/problems/laplace_system.hpp>
#include <concino/fields/detail/problems/make_similar_solver.hpp>
#include <concino/fields/detail/problems/masses.hpp>
#include <concino/fields/detail/problems/neumann.hpp>
#include <concino/fields/detail/problems/scaled_mesh.hpp>
#include <concino/solve/auto_solver.hpp>

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

/// Prescribed values and fluxes of the solution. T: double or vec3.
template<class M, class T = double>
struct poisson_options {
  std::vector<std::pair<vert_t<M>, T>> values = {};    // prescribed at these verts; finite; a vert may be listed twice
                                                       // with the same value
  std::vector<std::pair<facet_t<M>, T>> fluxes = {};   // outward derivatives across edges (faces of volumes) on the
                                                       // boundary, in units of u over length
  double isolated_value = 0;                           // at verts without edges and without a prescribed value, in each
                                                       // component; any number, NaN too
  concino::progress progress = nullptr;                // called with "Poisson's equation", "factorising", "solving"
  concino::profiler* profiler = nullptr;               // measures the call and its steps
};
struct prepare_poisson_options {
  concino::progress progress = nullptr;  // called with "Poisson's equation", "factorising"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

namespace detail {

/// The unknowns and their system, with prescribed values at some verts. Shared by poisson and prepare_poisson. All
/// computations use coordinates times 2^-exponent, so that the size is near 1.
template<class M>
class poisson_problem {
  static constexpr const char* caller = "poisson";
  constrained_system<M> system_;
  Eigen::SparseMatrix<double> mass_;
  int exponent_;

  poisson_problem(constrained_system<M>&& system, Eigen::SparseMatrix<double>&& mass, int exponent)
      : system_(std::move(system)), exponent_(exponent) {
    mass_.swap(mass);
  }

  template<class T, class F>
  right_hand_sides<T> load(const M& m, const F& f, const poisson_options<M, T>& options) const {
    return poisson_load<T>(views::scaled<M>(m, exponent_), mass_times<T>(m, mass_, f, "poisson: the load f"),
                           options.fluxes, caller);
  }

 public:
  /// fixed: verts, or pairs of a vert and a value.
  template<class V, class D>
  static poisson_problem make(const M& m, const V& fixed, const D& discretisation, const progress& on_progress) {
    report_progress(on_progress, 0, "Poisson's equation");
    constrained_verts<M> constrained(m);
    constrained.constrain(m, fixed, caller);
    constrained.number_reached(m, coupling_edges<M, D>(m, discretisation), caller);
    return at_unit_size(m, discretisation, [&](const auto& at, int exponent) -> poisson_problem {
      auto system = laplace_system(at, std::move(constrained), discretisation, 1, caller);
      return {std::move(system), mass_matrix(at, {.lumped = false}), exponent};
    });
  }

  std::size_t num_isolated() const { return system_.verts.num_isolated; }

  template<class Solver>
  void factorize(Solver& solver, const progress& on_progress) const { system_.factorize(solver, on_progress, caller); }

  /// The data of one query.
  template<class T>
  struct query {
    vert_map<M, T> u;  // prescribed values, and isolated_value elsewhere
    right_hand_sides<T> rhs;
  };
  template<class T, class F>
  query<T> make_query(const M& m, const F& f, const poisson_options<M, T>& options) const {
    auto u = prescribed_values<T>(m, system_.verts, options.values, options.isolated_value, caller);
    return {std::move(u), load<T>(m, f, options)};
  }

  template<class T, class Solver>
  vert_map<M, T> solve(const Solver& solver, query<T>&& q, const progress& on_progress) const {
    report_progress(on_progress, 0.9, "solving");
    system_.template solve<T>(solver, [&](std::size_t k, int i) { return q.rhs[k][i]; }, q.u, caller);
    report_progress(on_progress, 1, "Poisson's equation");
    return std::move(q.u);
  }
};

}  // namespace detail

/// A system prepared by prepare_poisson. Several threads may use it if the solver allows it. Copies share the prepared
/// data.
template<class M, class Solver>
class prepared_poisson {
  struct preparation {
    detail::poisson_problem<M> problem;
    std::unique_ptr<Solver> solver;
  };
  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const preparation> prepared_;

 public:
  template<class V, class D>
  prepared_poisson(const M& m, const V& fixed, const D& discretisation, const prepare_poisson_options& input_options,
                   const Solver& solver) : mesh_(m) {
    const core::profiled_options options(input_options, "prepare_poisson");
    auto own = detail::make_similar_solver(solver);
    auto problem = detail::poisson_problem<M>::make(m, fixed, discretisation, options->progress);
    problem.factorize(*own, options->progress);
    prepared_ = std::make_shared<const preparation>(preparation{std::move(problem), std::move(own)});
    detail::report_progress(options->progress, 1, "Poisson's equation");
  }

  const M& mesh() const { return mesh_.get(); }
  const Solver& solver() const { return *prepared_->solver; }
  /// The number of verts without edges and without a prescribed value. They get isolated_value.
  std::size_t num_isolated() const { return prepared_->problem.num_isolated(); }

  /// The solution for the load f, with prescribed values at the constrained verts and outward derivatives on the
  /// boundary.
  /// Needs:  f and options as for poisson; values: at least one for each constrained vert and none elsewhere. The mesh
  ///         has not changed since it was prepared.
  /// Result: that of poisson with these arguments.
  /// Cost:   one back-substitution, three for vectors, and a product with the mass matrix.
  /// Errors: as poisson about values, loads and fluxes; invalid_argument if a constrained vert has no value, or another
  ///         vert has one.
  template<class F, class T = detail::field_value_of<F, M>>
    requires requirement::is_given_field<F, M>
  vert_map<M, T> solve(const F& f, const poisson_options<M, std::type_identity_t<T>>& options = {}) const {
    auto q = prepared_->problem.template make_query<T>(mesh_.get(), f, options);
    return prepared_->problem.template solve<T>(*prepared_->solver, std::move(q), options.progress);
  }
};

/// Prepares Poisson's equation with prescribed values at the same verts, for many loads, values and fluxes: auto p =
/// prepare_poisson(m, {b}); auto u = p.solve(f, {.values = {{b, 0.0}}}).
/// Needs:  as poisson; the mesh must not change afterwards. `fixed`: verts in braces or any container. solver: the
///         result keeps a solver of the same type, constructed from its options() if it has them.
/// Result: an object with solve(...); num_isolated() is the number of verts that get isolated_value.
/// Cost:   that of poisson without the back-substitution.
/// Errors: as poisson, except those about values, loads and fluxes; invalid_mesh if a vert of `fixed` is no vert of m.
template<class M, class V = std::initializer_list<vert_t<M>>, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && detail::names_elements<V, vert_t<M>> &&
      SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_poisson<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_poisson(
              M&& m, const V& fixed, const prepare_poisson_options& options = {},
              Solver&& solver = auto_solver({.questions = 20})) {
    return {m, fixed, virtual_elements, options, solver};
  }
template<class M, class V = std::initializer_list<vert_t<M>>, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && Discretisation<D, M> &&
      detail::names_elements<V, vert_t<M>> &&
      SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_poisson<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_poisson(
              M&& m, const V& fixed, const D& discretisation, const prepare_poisson_options& options = {},
              Solver&& solver = auto_solver({.questions = 20})) {
    return {m, fixed, discretisation, options, solver};
  }

/// Solves Poisson's equation -(Laplacian of u) = f for a function u on the verts, in its weak form -L u = M f + S. The
/// options prescribe values of u at some verts and outward derivatives du/dn on parts of the boundary: poisson(m, f,
/// {.values = {{a, 0.0}}, .fluxes = {{e, 1.0}}}). Where the boundary has neither, du/dn is 0. L is the Laplacian of the
/// discretisation, which is passed after the load; the default is virtual_elements.
/// Needs:  EmbeddedMesh M, with a Discretisation also what that needs. f: any readable map over verts, f[v], or
///         function of the point of a vert, f(x) with a vec3 x, in units of u over length^2. Its values are numbers, or
///         points for vectors, which are solved for component by component; then values and fluxes are points too.
///         Values: at least one in each component. Fluxes: edges of a surface or faces of a volume on the boundary,
///         with the outward derivative, constant on the edge or face. A facet may be listed twice with the same flux.
///         solver: as for harmonic_map.
/// Result: a map of double or vec3, u[v]. Prescribed values are exact. M is the Galerkin mass: the load is integrated
///         against the projected hat functions. A lumped mass would lose the order of the error, which is 2 in the size
///         of the polys with virtual_elements. S integrates the hat functions over edges and faces exactly as the
///         Laplacian of virtual_elements does. Linear functions are reproduced where the mesh is planar, or a volume
///         with planar faces on the boundary. Verts without edges get isolated_value unless a value is prescribed;
///         prepare_poisson counts them. Edges of no poly do not count, unless the discretisation gives them a weight,
///         as uniform does. f is not read at verts of no poly.
/// Cost:   one factorisation of a sparse matrix with as many unknowns as there are verts to solve for. On large meshes
///         the default solver iterates instead, in time proportional to their number.
/// Errors: as harmonic_map with the same discretisation. invalid_argument if f is not finite at a vert of a poly, or a
///         flux is not finite or given twice with different values. invalid_mesh if a poly has no area or volume or has
///         points that are not finite. invalid_mesh if a flux is given at what is no edge or face of m, or at one that
///         does not have exactly one poly.
/// Source: Beirao da Veiga et al. 2013, Ahmad et al. 2013 (the load); paper section 2.2.
template<class M, class F, class T = detail::field_value_of<F, M>, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && requirement::is_given_field<F, M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, T> poisson(M&& m, const F& f,
                                 const poisson_options<std::remove_cvref_t<M>, detail::field_value_of<F, M>>& options =
                                     {},
                                 Solver&& solver = {}) {
    return poisson(m, f, virtual_elements, options, solver);
  }
template<class M, class F, class T = detail::field_value_of<F, M>, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && requirement::is_given_field<F, M> &&
      Discretisation<D, M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, T> poisson(M&& m, const F& f, const D& discretisation,
                                 const poisson_options<std::remove_cvref_t<M>, std::type_identity_t<T>>& input_options =
                                     {},
                                 Solver&& solver = {}) {
    const core::profiled_options profiled(input_options, "poisson");
    const auto& options = *profiled;
    const std::remove_cvref_t<M>& mesh_in = m;
    const auto problem = detail::poisson_problem<std::remove_cvref_t<M>>::make(mesh_in, options.values, discretisation,
                                                                               options.progress);
    auto q = problem.template make_query<T>(mesh_in, f, options);
    problem.factorize(solver, options.progress);
    return problem.template solve<T>(solver, std::move(q), options.progress);
  }

// What to write instead of calls that cannot compile.
template<class... T> void prepare_poisson(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void prepare_poisson(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_poisson(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void prepare_poisson(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void poisson(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void poisson(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void poisson(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_or_points_at_verts>>
  requires(EmbeddedMesh<M> && !requirement::is_given_field<U, M>)
void poisson(M&&, const U&, ...) = delete;  // a number or a point at each vert: make_vert_map<double>(m)

}  // namespace concino
