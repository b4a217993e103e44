// Poisson's equation: the function whose Laplacian is given, with values given at some verts and derivatives across the boundary. On any mesh.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/progress.hpp>
#include <concino/fields/detail/another_solver.hpp>
#include <concino/fields/detail/dirichlet.hpp>
#include <concino/fields/detail/laplace_system.hpp>
#include <concino/fields/detail/masses.hpp>
#include <concino/fields/detail/neumann.hpp>
#include <concino/fields/detail/scaled_mesh.hpp>
#include <concino/solve/auto_solver.hpp>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>

namespace concino {

struct poisson_options {
  concino::weights weights = concino::weights::standard;  // of the Laplacian L
  double isolated_value = 0;              // of verts without edges that have no value prescribed, in each part; any, NaN too
  concino::progress progress = nullptr;   // told "Poisson's equation", "factorising", "solving"
};

namespace detail {

/// Without fluxes.
template<class M, class T> using no_fluxes = std::initializer_list<std::pair<facet_t<M>, T>>;

/// All at a size near 1, where coordinates are 2^-exponent as large.
template<class M>
struct poisson_problem {
  held_system<M> system;
  Eigen::SparseMatrix<double> mass;
  int exponent;

  poisson_problem(const M& m, held_verts<M>&& held, weights which) : poisson_problem(numbered(m, std::move(held)), m, which) {}

  /// The right-hand side: M f + S at this size, where u is a length^2 of f and a length of the fluxes.
  template<class T, class F, class N>
  right_hand_sides<T> load(const M& m, const F& f, const N& fluxes) const {
    auto sum = mass_times<T>(m, mass, f, "poisson: the load f");
    enlarge(sum);
    add_fluxes<T>(views::scaled<M>(m, exponent), fluxes, sum, "poisson");
    enlarge(sum);
    return sum;
  }

 private:
  static held_verts<M> numbered(const M& m, held_verts<M>&& held) {
    held.number_reached(m, "poisson");
    return std::move(held);
  }
  poisson_problem(held_verts<M>&& held, const M& m, weights which)
      : poisson_problem(std::move(held), views::scaled<M>(m, which == weights::uniform ? 0 : length_exponent(m)), which) {}
  poisson_problem(held_verts<M>&& held, const views::scaled<M>& at, weights which)
      : system(laplace_system(at, std::move(held), which, 1, "poisson")), mass(mass_matrix(at, {.lumped = false})), exponent(at.exponent()) {}

  void enlarge(auto& sides) const {
    if (exponent == 0) return;
    for (auto& side : sides)
      for (Eigen::Index i = 0; i < side.size(); ++i) side[i] = std::ldexp(side[i], exponent);
  }
};

}  // namespace detail

/// What prepare_poisson prepares: it solves, from several threads too if the solver can. Copies share what was prepared.
template<class M, class Solver>
class prepared_poisson {
  struct preparation {
    detail::poisson_problem<M> problem;
    std::unique_ptr<Solver> solver;
    double isolated_value;
  };

  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const preparation> prepared_;

 public:
  template<class V>
  prepared_poisson(const M& m, const V& fixed, const poisson_options& options, const Solver& solver) : mesh_(m) {
    detail::tell(options.progress, 0, "Poisson's equation");
    detail::held_verts<M> held(m);
    held.hold(m, fixed, "poisson");
    auto own = detail::another_solver(solver);
    detail::poisson_problem<M> problem(m, std::move(held), options.weights);
    problem.system.factorize(*own, options.progress, "poisson");
    prepared_ = std::make_shared<const preparation>(preparation{std::move(problem), std::move(own), options.isolated_value});
    detail::tell(options.progress, 1, "Poisson's equation");
  }

  const M& mesh() const { return mesh_.get(); }
  const Solver& solver() const { return *prepared_->solver; }
  /// How many verts have no edges and no value prescribed: they get isolated_value.
  std::size_t isolated() const { return prepared_->problem.system.verts.num_isolated; }

  /// The function with the load f, these values at the verts that were named before, and these outward derivatives on the boundary.
  /// Needs:  f and fluxes as for poisson; values: one at least for each of those verts and none elsewhere. The mesh is as it was prepared.
  /// Result: that of poisson with these.
  /// Cost:   one back-substitution, three for vectors, and a product with the mass.
  /// Errors: as poisson about values, loads and fluxes; invalid_argument if one of those verts has no value, or one that was not named has.
  template<class F, class T = detail::field_value_at<F, vert_t<M>>, class D = std::initializer_list<std::pair<vert_t<M>, T>>,
           class N = detail::no_fluxes<M, T>>
    requires requirement::gives_numbers_or_points<F, vert_t<M>> && detail::gives_values<D, vert_t<M>> && detail::walkable<N>
  vert_map<M, T> solve(const F& f, const D& values, const N& fluxes = {}) const {
    const M& m = mesh_.get();
    auto value = detail::prescribed_values<T>(m, prepared_->problem.system.verts, values, prepared_->isolated_value, "poisson");
    const auto load = prepared_->problem.template load<T>(m, f, fluxes);
    prepared_->problem.system.template solve<T>(*prepared_->solver, [&](std::size_t k, int i) { return load[k][i]; }, value, "poisson");
    return value;
  }
};

/// Prepares Poisson's equation with values given at the same verts, for many loads, values and fluxes: auto p = prepare_poisson(m, {b});
/// auto u = p.solve(f, {{b, 0.0}}).
/// Needs:  as poisson; the mesh stays as it is. `fixed`: verts in braces or any container. solver: one like it is kept, made of its options()
///         where it has them.
/// Result: an object that answers solve(...), and tells by isolated() how many verts got isolated_value.
/// Cost:   that of poisson, but for the back-substitution.
/// Errors: as poisson, but for those about values, loads and fluxes; invalid_mesh if a vert to be fixed is no vert of m.
template<class M, class V = std::initializer_list<vert_t<M>>, class Solver = auto_solver>
  requires AnyMesh<M> && Embedded<M> && requirement::is_no_temporary<M> && detail::names_elements<V, vert_t<M>> &&
           SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
prepared_poisson<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_poisson(M&& m, const V& fixed, const poisson_options& options = {},
                                                                                      Solver&& solver = {}) {
  return {m, fixed, options, solver};
}

/// The function u on the verts with -L u = M f + S, the weak form of -(Laplacian of u) = f, the given values at some verts, and the given outward
/// derivatives du/dn on some of the boundary. Where neither is given there, the derivative across it is 0.
/// Needs:  Embedded AnyMesh; for cotangent weights all polys triangles or tets. f: any readable map over verts, f[v], in units of u over
///         length^2; numbers, or points for vectors, which are solved for part by part. `values` and solver as for harmonic_map. `fluxes`: edges of
///         a surface or faces of a volume and numbers (or points), in braces ({{e, 1.0}}) or any container of pairs: the derivative
///         in the direction out of the mesh, constant on the edge or face, in units of u over length. The same one twice is fine. They
///         stand before the options, and are told from them by their type; {} means none and default options alike.
/// Result: a map of double or vec3, u[v]. Given values are exact. M is the Galerkin mass: the load is integrated against the projected hat functions,
///         since lumping it would cost the order of the error, 2 in the size of the polys with standard weights. S integrates the hat functions over
///         edges and faces exactly as the Laplacian of standard weights has them: linear functions are reproduced where the mesh is planar, or a
///         volume with planar faces on the boundary. Verts without edges get isolated_value unless a value is given; prepare_poisson counts
///         them; f is not read at verts of no poly.
/// Cost:   one sparse factorisation of as many unknowns as there are verts to find.
/// Errors: as harmonic_map with the same weights; invalid_argument if f is not finite at a vert of a poly, or a flux is not finite or given
///         twice differently; invalid_mesh if a poly has no area or volume, or points that are not finite, or if a flux is given at what is no
///         edge or face of m or has not exactly one poly.
/// Source: Beirao da Veiga et al. 2013, Ahmad et al. 2013 (the load); paper section 2.2.
template<class M, class F, class T = detail::field_value_at<F, vert_t<M>>, class D = std::initializer_list<std::pair<vert_t<M>, T>>,
         class N = detail::no_fluxes<M, T>, class Solver = auto_solver>
  requires AnyMesh<M> && Embedded<M> && requirement::is_no_temporary<M> && requirement::gives_numbers_or_points<F, vert_t<M>> && detail::gives_values<D, vert_t<M>> && detail::walkable<N> &&
           SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, T> poisson(M&& m, const F& f, const D& values, const N& fluxes, const poisson_options& options = {}, Solver&& solver = {}) {
  const std::remove_cvref_t<M>& mesh_in = m;
  detail::tell(options.progress, 0, "Poisson's equation");
  detail::held_verts<std::remove_cvref_t<M>> held(mesh_in);
  held.hold(mesh_in, values, "poisson");
  auto value = detail::prescribed_values<T>(mesh_in, held, values, options.isolated_value, "poisson");
  const detail::poisson_problem<std::remove_cvref_t<M>> problem(mesh_in, std::move(held), options.weights);
  const auto load = problem.template load<T>(mesh_in, f, fluxes);
  problem.system.factorize(solver, options.progress, "poisson");
  detail::tell(options.progress, 0.9, "solving");
  problem.system.template solve<T>(solver, [&](std::size_t k, int i) { return load[k][i]; }, value, "poisson");
  detail::tell(options.progress, 1, "Poisson's equation");
  return value;
}
/// The same without fluxes.
template<class M, class F, class T = detail::field_value_at<F, vert_t<M>>, class D = std::initializer_list<std::pair<vert_t<M>, T>>,
         class Solver = auto_solver>
  requires AnyMesh<M> && Embedded<M> && requirement::is_no_temporary<M> && requirement::gives_numbers_or_points<F, vert_t<M>> && detail::gives_values<D, vert_t<M>> &&
           SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, T> poisson(M&& m, const F& f, const D& values, const poisson_options& options = {}, Solver&& solver = {}) {
  return poisson(m, f, values, detail::no_fluxes<M, T>{}, options, solver);
}

// What to write instead of calls that cannot compile.
template<class... T> void prepare_poisson(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling
template<class... T> void prepare_poisson(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_poisson(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void prepare_poisson(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void poisson(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling
template<class... T> void poisson(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void poisson(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_or_points_at_verts>>
  requires(AnyMesh<M> && Embedded<M> && !requirement::gives_numbers_or_points<U, vert_t<M>>)
void poisson(M&&, const U&, ...) = delete;  // a number or a point at each vert: make_vert_map<double>(m)

}  // namespace concino
