// Harmonic maps: the smoothest function through given values at some verts. The paper's example, on any mesh.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/detail/message.hpp>
#include <concino/detail/number_text.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/operators/detail/assembly.hpp>
#include <concino/operators/detail/product.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/operators/weights.hpp>
#include <concino/progress.hpp>
#include <concino/solve/ldlt.hpp>
#include <concino/solve/detail/residual.hpp>

#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

namespace concino {

struct harmonic_map_options {
  concino::weights weights = concino::weights::uniform;
  int exponent = 1;                       // n >= 1: L (M^-1 L)^(n-1) u = 0; 1: harmonic, 2: biharmonic, ...
  double isolated_value = 0;              // of verts without edges that have no value prescribed; any, NaN too
  concino::progress progress = nullptr;
};

namespace detail {

/// The verts whose values are to be found, numbered; the others are prescribed or stand alone.
template<class M>
struct dirichlet_problem {
  enum : int { prescribed = -1, isolated = -2, reached = -3 };
  vert_map<M, double> value;
  vert_map<M, int> unknown;  // number, prescribed or isolated; before they are numbered, reached
  int unknowns = 0;

  /// Adds to `front` all verts that can be reached from it, and marks them.
  void reach(const M& m, std::vector<vert_t<M>>& front) {
    for (std::size_t i = 0; i < front.size(); ++i) {
      const vert_t<M> v = front[i];
      for (const vert_t<M> w : adj_v2v(m, v)) {
        if (unknown[w] != isolated) continue;
        unknown[w] = reached;
        front.push_back(w);
      }
    }
  }
};

[[noreturn, gnu::noinline, gnu::cold]] inline void throw_not_finite(const char* who, std::size_t vert) {
  throw_joined<invalid_argument>({who, ": the value given at vert ", vert, " is not finite"});
}
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_two_values(const char* who, std::size_t vert, double x, double y) {
  throw_joined<invalid_argument>({who, ": two values are given at vert ", vert, ", ", number_text(x), " and ", number_text(y), "; keep one"});
}
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_nothing_given(const char* who, std::size_t vert, std::size_t component) {
  throw_joined<solver_error>({who, ": singular, because the component of vert ", vert, " (", component,
                              " verts) has no value prescribed; give one at any of its verts"});
}

template<class M, class D>
dirichlet_problem<M> dirichlet(const M& m, const D& given, double isolated_value, const char* who) {
  using problem = dirichlet_problem<M>;
  problem r{make_vert_map<double>(m, isolated_value), make_vert_map<int>(m, problem::isolated)};
  std::vector<vert_t<M>> front;
  for (const auto& [vert, number] : given) {
    const vert_t<M> v = vert;
    const double x = static_cast<double>(number);
    if (!contains(m, v)) throw_joined<invalid_mesh>({who, ": a value is given at something that is no vert of the mesh; take verts from verts(m)"});
    if (!std::isfinite(x)) throw_not_finite(who, index_of(m, v));
    if (r.unknown[v] != problem::prescribed) front.push_back(v);
    else if (r.value[v] != x) throw_two_values(who, index_of(m, v), r.value[v], x);
    r.unknown[v] = problem::prescribed;
    r.value[v] = x;
  }
  r.reach(m, front);
  for (const vert_t<M> v : verts(m)) {
    if (r.unknown[v] == problem::prescribed) continue;
    if (r.unknown[v] == problem::isolated) {
      const auto& around = adj_v2v(m, v);
      if (!(around.begin() != around.end())) continue;
      front.clear();
      front.push_back(v);
      r.unknown[v] = problem::reached;
      r.reach(m, front);
      throw_nothing_given(who, index_of(m, v), front.size());
    }
    r.unknown[v] = r.unknowns++;
  }
  return r;
}

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

/// A (M^-1 A)^(n-1), n > 1.
inline Eigen::SparseMatrix<double> polyharmonic(const Eigen::SparseMatrix<double>& a, const std::vector<double>& inverse_mass, int exponent) {
  Eigen::SparseMatrix<double> k = scaled_product(a, inverse_mass, a);
  for (int n = 2; n < exponent; ++n) k = scaled_product(a, inverse_mass, k);
  return k;
}

/// The rows and columns of the unknowns, lower triangle; what the prescribed values contribute goes to b.
template<class M>
Eigen::SparseMatrix<double> restrict_to_unknowns(const Eigen::SparseMatrix<double>& k, const M& m, const dirichlet_problem<M>& problem, Eigen::VectorXd& b) {
  Eigen::SparseMatrix<double> r(problem.unknowns, problem.unknowns);
  r.resizeNonZeros(k.nonZeros());
  std::vector<int> column(static_cast<std::size_t>(problem.unknowns));
  for (const vert_t<M> v : verts(m))
    if (const int c = problem.unknown[v]; c >= 0) column[static_cast<std::size_t>(c)] = static_cast<int>(index_of(m, v));
  const int* const unknown = problem.unknown.values().data();
  const double* const value = problem.value.values().data();
  int* const rows = r.innerIndexPtr();
  double* const entries = r.valuePtr();
  int at = 0;
  for (int c = 0; c < problem.unknowns; ++c) {
    const int first = at, from = column[static_cast<std::size_t>(c)];
    for (int l = k.outerIndexPtr()[from]; l < k.outerIndexPtr()[from + 1]; ++l) {
      const int i = k.innerIndexPtr()[l], row = unknown[i];
      const double x = k.valuePtr()[l];
      if (row < 0) b[c] -= x * value[i];
      if (row < c) continue;
      rows[at] = row;
      entries[at++] = x;
    }
    sort_column(rows + first, entries + first, static_cast<std::size_t>(at - first));
    r.outerIndexPtr()[c + 1] = at;
  }
  r.resizeNonZeros(at);
  return r;
}

}  // namespace detail

/// The function u on the verts with the given values that is harmonic everywhere else: L u = 0, or L (M^-1 L)^(n-1) u = 0 for
/// exponent n, with M the identity for uniform weights and the lumped mass otherwise.
/// Needs:  PrimalGraph M; for cotangent weights an Embedded mesh of triangles or tets. `values`: verts and numbers, in braces
///         ({{a, 0.0}, {b, 1.0}}) or any container of pairs; the same vert twice is fine if the value is the same.
///         solver: a SparseSolver for symmetric positive definite matrices.
/// Result: a map of double, u[v]. Given values are exact. Verts without edges get isolated_value unless one is given. With uniform
///         weights and exponent 1 every value lies between the extrema of those given in its component.
/// Cost:   one sparse factorisation of as many unknowns as there are verts to find.
/// Errors: invalid_mesh if a value is given at what is no vert of m; invalid_argument if a value is not finite, a vert gets two, or
///         exponent < 1; solver_error if a component that has edges has no value prescribed (one of its verts is named), or if the
///         system cannot be solved in double precision; with cotangent weights also those of `laplacian`; cancelled.
/// Source: Tutte 1963, Pinkall, Polthier 1993, Botsch, Kobbelt 2004 (higher exponents); paper section 3.
template<class M, class D = std::initializer_list<std::pair<vert_t<M>, double>>, class Solver = ldlt>
  requires PrimalGraph<M> && requirement::is_no_temporary<M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> harmonic_map(M&& m, const D& values, const harmonic_map_options& options = {}, Solver&& solver = {}) {
  using mesh = std::remove_cvref_t<M>;
  const mesh& mesh_in = m;
  if (options.exponent < 1)
    throw invalid_argument("harmonic_map: exponent is " + detail::number_text(options.exponent) + "; it must be 1 or more");
  detail::tell(options.progress, 0, "harmonic map: assembling");
  auto problem = detail::dirichlet(mesh_in, values, options.isolated_value, "harmonic_map");

  Eigen::VectorXd b(problem.unknowns);
  b.setZero();
  const Eigen::SparseMatrix<double> a = [&] {
    const auto minus_laplacian = [&](const vert_map<M, int>& row_of, std::size_t size) {
      return detail::with_weights(mesh_in, options.weights, [&](const auto& weights) {
        return detail::assemble<detail::lower_triangle>(
            mesh_in, weights, size, 1.0, [&](const vert_t<M>& v) { return row_of[v]; },
            [&](int row, const vert_t<M>& w, double weight) { b[row] += weight * problem.value[w]; });
      });
    };
    if (options.exponent == 1) return minus_laplacian(problem.unknown, static_cast<std::size_t>(problem.unknowns));
    // Of the powers the verts with given values are part too.
    auto row_of = make_vert_map<int>(mesh_in);
    for (const vert_t<M> v : verts(mesh_in)) row_of[v] = static_cast<int>(index_of(mesh_in, v));
    const auto all = detail::with_both_triangles(minus_laplacian(row_of, static_cast<std::size_t>(vert_index_bound(mesh_in))));
    const auto k = detail::polyharmonic(all, detail::inverse_masses(mesh_in, all, options.weights), options.exponent);
    return detail::restrict_to_unknowns(k, mesh_in, problem, b);
  }();
  if (problem.unknowns > 0) {
    detail::tell(options.progress, 0.1, "harmonic map: factorising");
    solver.factorize(a);
    detail::tell(options.progress, 0.9, "harmonic map: solving");
    const Eigen::VectorXd u = detail::solve_and_check(solver, a, b, "harmonic_map");
    for (const vert_t<M> v : verts(mesh_in))
      if (const int i = problem.unknown[v]; i >= 0) problem.value[v] = u[i];
  }
  detail::tell(options.progress, 1, "harmonic map: done");
  return std::move(problem.value);
}

}  // namespace concino
