// Harmonic maps: the smoothest function through given values at some verts. The paper's example, on any mesh.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/detail/number_text.hpp>
#include <concino/fields/detail/dirichlet.hpp>
#include <concino/operators/detail/assembly.hpp>
#include <concino/operators/detail/product.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/operators/weights.hpp>
#include <concino/progress.hpp>
#include <concino/solve/ldlt.hpp>

#include <initializer_list>
#include <utility>
#include <vector>

namespace concino {

struct harmonic_map_options {
  concino::weights weights = concino::weights::standard;
  int exponent = 1;                       // n >= 1: L (M^-1 L)^(n-1) u = 0; 1: harmonic, 2: biharmonic, ...
  double isolated_value = 0;              // of verts without edges that have no value prescribed, in each part; any, NaN too
  concino::progress progress = nullptr;
};

namespace detail {

/// 1 / mass of each vert, for M^-1 in powers of the Laplacian: 1 for uniform weights, else by the lumped mass. `a` is minus the Laplacian.
template<class M>
std::vector<double> inverse_masses(const M& m, const Eigen::SparseMatrix<double>& a, concino::weights which) {
  std::vector<double> inverse(static_cast<std::size_t>(a.cols()), 1.0);
  if constexpr (AnyMesh<M> && Embedded<M>) {
    if (which == weights::uniform) return inverse;
    const auto mass = vert_masses(m);
    for (const vert_t<M> v : verts(m)) {
      const std::size_t i = index_of(m, v);
      if (mass[v] > 0) inverse[i] = 1 / mass[v];
      else if (a.coeff(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) != 0)
        throw invalid_mesh("harmonic_map: vert " + number_text(i) + " has edges but no polys with a measure, so no mass; use uniform weights");
    }
  }
  return inverse;
}

/// Minus the Laplacian as far as it stands on edges, lower triangle; row_of[v] is the row of vert v, negative where it has none because a value is
/// prescribed there, whose contribution goes to b. Summed poly by poly it is whole, by index_of, with both triangles: `is_whole` tells.
template<class T, class M>
Eigen::SparseMatrix<double> minus_laplacian(const M& m, concino::weights which, const vert_map<M, int>& row_of, std::size_t size,
                                            const dirichlet_problem<M, T>& problem, right_hand_sides<T>& b, bool& is_whole) {
  is_whole = false;
  return with_weights(
      m, which,
      [&](const auto& weights) {
        return assemble<lower_triangle>(
            m, weights, size, 1.0, [&](const vert_t<M>& v) { return row_of[v]; },
            [&](int row, const vert_t<M>& w, double weight) { problem.add_prescribed(b, row, problem.value[w], weight); });
      },
      [&](auto make_element) {
        is_whole = true;
        return assemble_stiffness(m, make_element, 1.0);
      });
}

/// The rows and columns of the unknowns of minus the Laplacian, lower triangle; what prescribed values contribute goes to b.
template<class T, class M>
Eigen::SparseMatrix<double> minus_laplacian_of_unknowns(const M& m, concino::weights which, const dirichlet_problem<M, T>& problem, right_hand_sides<T>& b) {
  bool is_whole;
  auto a = minus_laplacian<T>(m, which, problem.unknown, static_cast<std::size_t>(problem.unknowns), problem, b, is_whole);
  return is_whole ? restrict_to_unknowns<T>(a, m, problem, b) : a;
}

/// All of it, both triangles.
template<class T, class M>
Eigen::SparseMatrix<double> whole_minus_laplacian(const M& m, concino::weights which, const dirichlet_problem<M, T>& problem, right_hand_sides<T>& b) {
  auto row_of = make_vert_map<int>(m);
  for (const vert_t<M> v : verts(m)) row_of[v] = static_cast<int>(index_of(m, v));
  bool is_whole;
  auto a = minus_laplacian<T>(m, which, row_of, static_cast<std::size_t>(vert_index_bound(m)), problem, b, is_whole);
  return is_whole ? a : with_both_triangles(a);
}

/// A (M^-1 A)^(n-1), n > 1.
inline Eigen::SparseMatrix<double> polyharmonic(const Eigen::SparseMatrix<double>& a, const std::vector<double>& inverse_mass, int exponent) {
  Eigen::SparseMatrix<double> k = scaled_product(a, inverse_mass, a);
  for (int n = 2; n < exponent; ++n) k = scaled_product(a, inverse_mass, k);
  return k;
}

}  // namespace detail

/// The function u on the verts with the given values that is harmonic everywhere else: L u = 0, or L (M^-1 L)^(n-1) u = 0 for
/// exponent n, with M the identity for uniform weights and the lumped mass otherwise. harmonic_map<vec3> maps to space, part by part.
/// Needs:  PrimalGraph M; for cotangent weights an Embedded mesh of triangles or tets. `values`: verts and numbers (or points), in braces
///         ({{a, 0.0}, {b, 1.0}}) or any container of pairs; the same vert twice is fine if the value is the same.
///         T: double or vec3. solver: a SparseSolver for symmetric positive definite matrices.
/// Result: a map of T, u[v]. Given values are exact. Verts without edges get isolated_value unless one is given. With standard weights
///         linear functions of planar surfaces and of volumes are harmonic, whatever the polys; with uniform weights and exponent 1 every
///         value lies between the extrema of those given in its component. On a mere graph standard weights are uniform ones.
/// Cost:   one sparse factorisation of as many unknowns as there are verts to find.
/// Errors: invalid_mesh if a value is given at what is no vert of m; invalid_argument if a value is not finite, a vert gets two, or
///         exponent < 1; solver_error if a component that has edges has no value prescribed (one of its verts is named), or if the
///         system cannot be solved in double precision; with other weights than uniform also those of `laplacian`; cancelled.
/// Source: Tutte 1963, Pinkall, Polthier 1993, Botsch, Kobbelt 2004 (higher exponents); paper section 3.
template<class T = double, class M, class D = std::initializer_list<std::pair<vert_t<M>, T>>, class Solver = ldlt>
  requires PrimalGraph<M> && requirement::is_no_temporary<M> && detail::field_value<T> &&
           SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, T> harmonic_map(M&& m, const D& values, const harmonic_map_options& options = {}, Solver&& solver = {}) {
  const std::remove_cvref_t<M>& mesh_in = m;
  if (options.exponent < 1)
    throw invalid_argument("harmonic_map: exponent is " + detail::number_text(options.exponent) + "; it must be 1 or more");
  detail::tell(options.progress, 0, "harmonic map");
  auto problem = detail::dirichlet<T>(mesh_in, values, options.isolated_value, "harmonic_map");
  auto b = problem.no_load();
  const Eigen::SparseMatrix<double> a = [&] {
    if (options.exponent == 1) return detail::minus_laplacian_of_unknowns<T>(mesh_in, options.weights, problem, b);
    const auto all = detail::whole_minus_laplacian<T>(mesh_in, options.weights, problem, b);  // of powers the verts with given values are part too
    const auto k = detail::polyharmonic(all, detail::inverse_masses(mesh_in, all, options.weights), options.exponent);
    return detail::restrict_to_unknowns<T>(k, mesh_in, problem, b);
  }();
  detail::solve_unknowns<T>(mesh_in, problem, a, b, solver, "harmonic_map", options.progress);
  detail::tell(options.progress, 1, "harmonic map");
  return std::move(problem.value);
}

}  // namespace concino
