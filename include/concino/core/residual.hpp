// Whether a computed solution solves: the residual of a symmetric system, measured against what rounding errors allow, and improved.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/system_checks.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <vector>

namespace concino::core {

/// r = b - a x, of a compressed matrix, or of a symmetric one given by its lower triangle. Loops, because Eigen's expressions take long to compile.
/// Result: the largest |r_i| / (|a| |x| + |b|)_i: the relative change of matrix and right-hand side that would make x exact. It does not
///         depend on the scale of rows.
inline double residual(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& x, const Eigen::VectorXd& b, Eigen::VectorXd& r,
                       bool is_lower_triangle) {
  const auto n = static_cast<int>(a.cols());
  std::vector<double> scale(static_cast<std::size_t>(n));
  double* const s = scale.data();
  r.resize(n);
  for (int i = 0; i < n; ++i) {
    r[i] = b[i];
    s[i] = std::abs(b[i]);
  }
  for (int c = 0; c < n; ++c) {
    for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k) {
      const int row = a.innerIndexPtr()[k];
      const double below = a.valuePtr()[k] * x[c];
      r[row] -= below;
      s[row] += std::abs(below);
      if (row == c || !is_lower_triangle) continue;
      const double above = a.valuePtr()[k] * x[row];
      r[c] -= above;
      s[c] += std::abs(above);
    }
  }
  double worst = 0;
  for (int i = 0; i < n; ++i) {
    const double e = r[i] == 0 ? 0 : std::abs(r[i]) / s[i];
    if (e > worst || std::isnan(e)) worst = e;
  }
  return worst;
}

/// The largest |r_i| / (|b_i| + the largest |a_ij| of the row times max|x|): rows of large entries do not hide the others, and what is small in x is not
/// measured by itself. a: as above.
inline double residual_beside_largest(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& x, const Eigen::VectorXd& b, const Eigen::VectorXd& r,
                                      bool is_lower_triangle) {
  std::vector<double> entry(static_cast<std::size_t>(a.cols()));
  double of_x = 0, worst = 0;
  for (int c = 0; c < a.cols(); ++c) {
    of_x = std::max(of_x, std::abs(x[c]));
    for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k) {
      const int row = a.innerIndexPtr()[k];
      const double size = std::abs(a.valuePtr()[k]);
      entry[static_cast<std::size_t>(row)] = std::max(entry[static_cast<std::size_t>(row)], size);
      if (is_lower_triangle) entry[static_cast<std::size_t>(c)] = std::max(entry[static_cast<std::size_t>(c)], size);
    }
  }
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    const double e = r[i] == 0 ? 0 : std::abs(r[i]) / (std::abs(b[i]) + entry[static_cast<std::size_t>(i)] * of_x);
    if (e > worst || std::isnan(e)) worst = e;
  }
  return worst;
}

[[noreturn, gnu::noinline, gnu::cold]] inline void throw_not_solved(const char* who, double error) {
  core::throw_joined<solver_error>({who, ": the system is too badly conditioned for double precision, or not what the solver is for: the relative"
                              " residual is ", core::number_text(error)});
}

/// Factorises a symmetric matrix given by its lower triangle, with the other triangle for solvers that say they read it.
template<class Solver>
void factorize_symmetric(Solver& solver, const Eigen::SparseMatrix<double>& lower) {
  if constexpr (requires { requires Solver::reads_both_triangles; }) {
    Eigen::SparseMatrix<double> whole;
    whole = lower.selfadjointView<Eigen::Lower>();
    solver.factorize(whole);
  } else {
    solver.factorize(lower);
  }
}

/// The same for a system over verts. vert_of(row): the index of a vert.
/// Errors: solver_error that names the problem, the vert at which the matrix is singular, and what helps.
template<class Solver, class VertOf>
void factorize_over_verts(Solver& solver, const Eigen::SparseMatrix<double>& lower, const char* who, const VertOf& vert_of) {
  try {
    factorize_symmetric(solver, lower);
  } catch (const singular_row& e) {
    core::throw_joined<solver_error>({who, ": the system is singular to working precision at vert ", static_cast<std::size_t>(vert_of(e.row)),
                                ": polys near it are too flat or too thin for double precision; remesh them, scale the mesh to more even lengths, or"
                                " remove them (", e.what(), ")"});
  }
}

/// Whether the matrix factorised last is solved by iteration, to a residual that the solver measures itself, beside the largest values of the solution:
/// parts that are far smaller than others have no correct digits.
template<class Solver>
bool iterates([[maybe_unused]] const Solver& solver) {
  if constexpr (requires { { solver.iterates() } -> std::convertible_to<bool>; }) return solver.iterates();
  else return false;
}

/// Solves with a factorised matrix, here compressed or its lower triangle, and makes up for rounding errors while that helps.
/// Errors: solver_error if what is left is more than 1e-8; of solvers that iterate, beside the largest values, more than 1e-5 and than ten times what the
///         solver says itself, as where the matrix is not what the solver took it for.
template<class Solver>
Eigen::VectorXd solve_and_check(const Solver& solver, const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& b, const char* who,
                                bool is_lower_triangle = true) {
  Eigen::VectorXd x = solver.solve(b), r;
  double error = residual(a, x, b, r, is_lower_triangle);
  if (iterates(solver)) {
    error = residual_beside_largest(a, x, b, r, is_lower_triangle);
    double told = 0;
    if constexpr (requires { { solver.residual() } -> std::convertible_to<double>; }) told = solver.residual();
    if (!(error <= std::max(1e-5, 10 * told))) throw_not_solved(who, error);
    return x;
  }
  for (int round = 0; round < 3 && error > 1e-13; ++round) {
    Eigen::VectorXd better = solver.solve(r);
    for (Eigen::Index i = 0; i < x.size(); ++i) better[i] += x[i];
    const double left = residual(a, better, b, r, is_lower_triangle);
    if (!(left < error)) break;
    x.swap(better);
    error = left;
  }
  if (!(error <= 1e-8)) throw_not_solved(who, error);
  return x;
}

}  // namespace concino::core
