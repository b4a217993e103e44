// Poisson's equation: the function whose Laplacian is given, with values given at some verts and derivatives across the boundary. On any mesh.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/sparse_solver.hpp>
#include <concino/fields/detail/another_solver.hpp>
#include <concino/fields/detail/dirichlet.hpp>
#include <concino/fields/detail/laplace_system.hpp>
#include <concino/fields/detail/masses.hpp>
#include <concino/fields/detail/neumann.hpp>
#include <concino/progress.hpp>
#include <concino/solve/auto_solver.hpp>

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>

namespace concino {

struct poisson_options {
  concino::weights weights = concino::weights::standard;
  double isolated_value = 0;              // of verts without edges that have no value prescribed, in each part; any, NaN too
  concino::progress progress = nullptr;
};

namespace detail {

/// Without fluxes.
template<class M, class T> using no_fluxes = std::initializer_list<std::pair<facet_t<M>, T>>;

template<class M>
held_system<M> poisson_system(const M& m, held_verts<M>&& held, weights which) {
  held.number_reached(m, "poisson");
  return laplace_system(m, std::move(held), which, 1, "poisson");
}

}  // namespace detail

/// What prepare_poisson prepares: it solves, from several threads too if the solver can. Copies share what was prepared.
template<AnyMesh M, class Solver>
  requires Embedded<M>
class prepared_poisson {
  struct preparation {
    detail::held_system<M> system;
    Eigen::SparseMatrix<double> mass;
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
    auto system = detail::poisson_system(m, std::move(held), options.weights);
    auto mass = mass_matrix(m, {.lumped = false});
    system.factorize(*own, options.progress);
    prepared_ = std::make_shared<const preparation>(preparation{std::move(system), std::move(mass), std::move(own), options.isolated_value});
    detail::tell(options.progress, 1, "Poisson's equation");
  }

  const M& mesh() const { return mesh_.get(); }
  const Solver& solver() const { return *prepared_->solver; }
  /// How many verts have no edges and no value prescribed: they get isolated_value.
  std::size_t isolated() const { return prepared_->system.verts.num_isolated; }

  /// The function with the load f, these values at the verts that were named before, and these outward derivatives on the boundary.
  /// Needs:  f and fluxes as for poisson; values: one at least for each of those verts and none elsewhere. The mesh is as it was prepared.
  /// Result: that of poisson with these.
  /// Cost:   one back-substitution, three for vectors, and a product with the mass.
  /// Errors: as poisson about values, loads and fluxes; invalid_argument if one of those verts has no value, or one that was not named has.
  template<class F, class T = detail::field_value_at<F, vert_t<M>>, class D = std::initializer_list<std::pair<vert_t<M>, T>>,
           class N = detail::no_fluxes<M, T>>
    requires ReadableMap<F, vert_t<M>> && detail::walkable<N>
  vert_map<M, T> solve(const F& f, const D& values, const N& fluxes = {}) const {
    const M& m = mesh_.get();
    auto value = detail::prescribed_values<T>(m, prepared_->system.verts, values, prepared_->isolated_value, "poisson");
    auto load = detail::mass_times<T>(m, prepared_->mass, f, "poisson: the load f");
    detail::add_fluxes<T>(m, fluxes, load, "poisson");
    prepared_->system.template solve<T>(*prepared_->solver, [&](std::size_t k, int i) { return load[k][i]; }, value, "poisson");
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
  requires AnyMesh<M> && Embedded<M> && requirement::is_no_temporary<M> &&
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
  requires AnyMesh<M> && Embedded<M> && requirement::is_no_temporary<M> && ReadableMap<F, vert_t<M>> && detail::walkable<N> &&
           SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, T> poisson(M&& m, const F& f, const D& values, const N& fluxes, const poisson_options& options = {}, Solver&& solver = {}) {
  const std::remove_cvref_t<M>& mesh_in = m;
  detail::tell(options.progress, 0, "Poisson's equation");
  detail::held_verts<std::remove_cvref_t<M>> held(mesh_in);
  held.hold(mesh_in, values, "poisson");
  auto value = detail::prescribed_values<T>(mesh_in, held, values, options.isolated_value, "poisson");
  const auto system = detail::poisson_system(mesh_in, std::move(held), options.weights);
  auto load = detail::mass_times<T>(mesh_in, mass_matrix(mesh_in, {.lumped = false}), f, "poisson: the load f");
  detail::add_fluxes<T>(mesh_in, fluxes, load, "poisson");
  system.factorize(solver, options.progress);
  detail::tell(options.progress, 0.9, "solving");
  system.template solve<T>(solver, [&](std::size_t k, int i) { return load[k][i]; }, value, "poisson");
  detail::tell(options.progress, 1, "Poisson's equation");
  return value;
}

/// The same without fluxes.
template<class M, class F, class T = detail::field_value_at<F, vert_t<M>>, class D = std::initializer_list<std::pair<vert_t<M>, T>>,
         class Solver = auto_solver>
  requires AnyMesh<M> && Embedded<M> && requirement::is_no_temporary<M> && ReadableMap<F, vert_t<M>> &&
           SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, T> poisson(M&& m, const F& f, const D& values, const poisson_options& options = {}, Solver&& solver = {}) {
  return poisson(m, f, values, detail::no_fluxes<M, T>{}, options, solver);
}

}  // namespace concino
