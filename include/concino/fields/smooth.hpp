// Smoothing of fields: what is near the given values and varies less. Of the points themselves it is implicit fairing.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/progress.hpp>
#include <concino/fields/detail/another_solver.hpp>
#include <concino/fields/detail/implicit.hpp>
#include <concino/fields/detail/scaled_mesh.hpp>
#include <concino/solve/auto_solver.hpp>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>

namespace concino {

struct smooth_options {
  concino::weights weights = concino::weights::standard;  // of the Laplacian L; on a mere graph standard ones are uniform
  int exponent = 1;                       // n >= 1: energy u . L (M^-1 L)^(n-1) u; 1: of the gradient (Dirichlet), 2: of the Laplacian
  concino::progress progress = nullptr;   // told "smoothing", "factorising", "solving"
};

namespace detail {

template<class M, class V>
implicit_system<M> smoothing_system(const M& m, double amount, const V& held, const smooth_options& options) {
  const char* const who = "smooth";
  if (!(amount >= 0 && std::isfinite(amount)))
    core::throw_joined<invalid_argument>({who, ": amount is ", core::number_text(amount), "; it must be finite and 0 or more"});
  if (options.exponent < 1) core::throw_joined<invalid_argument>({who, ": exponent is ", core::number_text(options.exponent), "; it must be 1 or more"});
  tell(options.progress, 0, "smoothing");
  held_verts<M> fixed(m);
  fixed.hold(m, held, who);
  return at_unit_size(m, options.weights, [&](const auto& at, int exponent) -> implicit_system<M> {
    auto mass = mass_beside(at, options.weights, true, who);
    return {m, std::move(fixed), std::move(mass), std::ldexp(amount, -2 * options.exponent * exponent),
            polyharmonic(at, options.weights, options.exponent, who), who};
  });
}

}  // namespace detail

/// What prepare_smooth prepares: it smooths, from several threads too if the solver can. Copies share what was prepared.
template<class M, class Solver>
class prepared_smooth {
  struct preparation {
    detail::implicit_system<M> system;
    std::unique_ptr<Solver> solver;
  };

  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const preparation> prepared_;

 public:
  template<class V>
  prepared_smooth(const M& m, double amount, const V& held, const smooth_options& options, const Solver& solver) : mesh_(m) {
    auto system = detail::smoothing_system(m, amount, held, options);
    auto own = detail::another_solver(solver);
    system.factorize(*own, options.progress);
    prepared_ = std::make_shared<const preparation>(preparation{std::move(system), std::move(own)});
    detail::tell(options.progress, 1, "smoothing");
  }

  const M& mesh() const { return mesh_.get(); }
  const Solver& solver() const { return *prepared_->solver; }
  /// How many verts have no edges and are not held: they keep their values.
  std::size_t isolated() const { return prepared_->system.held().num_isolated; }

  /// The smoothed f.
  /// Needs:  f as for smooth; the mesh is as it was prepared.
  /// Result: that of smooth.      Cost: one back-substitution, three for vectors.
  /// Errors: as smooth about f; solver_error.
  template<class F, class T = detail::field_value_at<F, vert_t<M>>>
    requires requirement::gives_numbers_or_points<F, vert_t<M>>
  vert_map<M, T> apply(const F& f) const {
    const M& m = mesh_.get();
    auto u = prepared_->system.template values_of<T>(m, f);
    prepared_->system.template apply<T>(*prepared_->solver, u);
    return u;
  }
};

/// Prepares smoothing by the same amount, for many fields: auto s = prepare_smooth(m, amount); auto u = s.apply(f).
/// Needs:  as smooth; the mesh stays as it is. solver: one like it is kept, made of its options() where it has them.
/// Result: an object that answers apply(f), and tells by isolated() how many verts have no edges.
/// Cost:   as smooth, but for the back-substitution.
/// Errors: as smooth, but for what is about f.
template<class M, class V = std::initializer_list<vert_t<M>>, class Solver = auto_solver>
  requires PrimalGraph<M> && requirement::is_no_temporary<M> && detail::names_elements<V, vert_t<M>> &&
           SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
prepared_smooth<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_smooth(M&& m, double amount, const V& held,
                                                                                    const smooth_options& options = {}, Solver&& solver = {}) {
  return {m, amount, held, options, solver};
}
template<class M, class Solver = auto_solver>
  requires PrimalGraph<M> && requirement::is_no_temporary<M> &&
           SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
prepared_smooth<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_smooth(M&& m, double amount, const smooth_options& options = {},
                                                                                    Solver&& solver = {}) {
  return {m, amount, detail::no_verts<M>{}, options, solver};
}

/// The u for which the sum of mass times |u - f|^2 plus amount times the energy of u is least: (M + amount L') u = M f, with L' minus the Laplacian
/// or, for exponent n, its power L' (M^-1 L')^(n-1), and M the lumped mass, for uniform weights the identity. Held verts keep their value.
/// Needs:  PrimalGraph M; on a mere graph standard weights are uniform ones, other weights need an Embedded AnyMesh, cotangent ones of triangles
///         or tets. f: any readable map over verts, of numbers, or of points for vectors, which are smoothed part by part with one
///         factorisation. amount: finite, 0 or more, in units of length^(2 exponent), without unit for uniform weights: features narrower than
///         its (2 exponent)-th root go. `held`: verts in braces ({a, b}) or any container; they stand before the options. solver as for harmonic_map.
/// Result: a map of double or vec3. Constants stay, and so does the sum of mass times value where nothing is held. Verts without edges keep what
///         they have; prepare_smooth counts them. Where nothing is held on the boundary, u meets it with slope 0, so linear functions bend
///         there. With uniform weights and exponent 1, values stay between the extrema of f; so they do with others as long as no weight
///         is negative.
/// Cost:   one sparse factorisation of as many unknowns as there are verts to find.
/// Errors: invalid_argument if amount or exponent is out of its range or f is not finite at a vert that has edges or is held; invalid_mesh if what
///         is to be held is no vert of m, or if a vert has edges and no mass; with other weights than uniform those of `laplacian`;
///         solver_error; cancelled.
/// Source: Whittaker 1923; of points: Desbrun, Meyer, Schroeder, Barr 1999, "Implicit fairing of irregular meshes using diffusion and curvature
///         flow".
template<class M, class F, class T = detail::field_value_at<F, vert_t<M>>, class V = std::initializer_list<vert_t<M>>, class Solver = auto_solver>
  requires PrimalGraph<M> && requirement::is_no_temporary<M> && requirement::gives_numbers_or_points<F, vert_t<M>> && detail::names_elements<V, vert_t<M>> &&
           SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, T> smooth(M&& m, const F& f, double amount, const V& held, const smooth_options& options = {}, Solver&& solver = {}) {
  const std::remove_cvref_t<M>& mesh_in = m;
  const auto system = detail::smoothing_system(mesh_in, amount, held, options);
  auto u = system.template values_of<T>(mesh_in, f);
  system.factorize(solver, options.progress);
  detail::tell(options.progress, 0.9, "solving");
  system.template apply<T>(solver, u);
  detail::tell(options.progress, 1, "smoothing");
  return u;
}
/// The same with nothing held.
template<class M, class F, class T = detail::field_value_at<F, vert_t<M>>, class Solver = auto_solver>
  requires PrimalGraph<M> && requirement::is_no_temporary<M> && requirement::gives_numbers_or_points<F, vert_t<M>> &&
           SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, T> smooth(M&& m, const F& f, double amount, const smooth_options& options = {}, Solver&& solver = {}) {
  return smooth(m, f, amount, detail::no_verts<M>{}, options, solver);
}

// What to write instead of calls that cannot compile.
template<class... T> void prepare_smooth(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling
template<class... T> void prepare_smooth(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void smooth(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling
template<class... T> void smooth(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_or_points_at_verts>>
  requires(PrimalGraph<M> && !requirement::gives_numbers_or_points<U, vert_t<M>>)
void smooth(M&&, const U&, ...) = delete;  // a number or a point at each vert: make_vert_map<double>(m)

}  // namespace concino
