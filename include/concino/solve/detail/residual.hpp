// Whether a computed solution solves: the residual of a symmetric system, measured against what rounding errors allow, and improved.
#pragma once

#include <concino/detail/message.hpp>
#include <concino/detail/number_text.hpp>
#include <concino/error.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <vector>

namespace concino::detail {

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
    if (!(e <= worst)) worst = e;
  }
  return worst;
}

/// |r| / |b|.
inline double relative_size(const Eigen::VectorXd& r, const Eigen::VectorXd& b) {
  double largest = 0, of_r = 0, of_b = 0;
  for (Eigen::Index i = 0; i < b.size(); ++i) largest = std::max(largest, std::abs(b[i]));
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    of_r += largest > 0 ? (r[i] / largest) * (r[i] / largest) : std::abs(r[i]);
    of_b += largest > 0 ? (b[i] / largest) * (b[i] / largest) : 0;
  }
  return of_r > 0 ? std::sqrt(of_r / of_b) : 0;
}

[[noreturn, gnu::noinline, gnu::cold]] inline void throw_not_solved(const char* who, double error) {
  throw_joined<solver_error>({who, ": the system is too badly conditioned for double precision, or not what the solver is for: the relative"
                              " residual is ", number_text(error)});
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

/// Whether the matrix factorised last is solved by iteration, to a residual that the solver measures itself: relative to |b|, so that parts of the
/// solution that are far smaller than others have no correct digits.
template<class Solver>
bool iterates([[maybe_unused]] const Solver& solver) {
  if constexpr (requires { { solver.iterates() } -> std::convertible_to<bool>; }) return solver.iterates();
  else return false;
}

/// Solves with a factorised matrix, here compressed or its lower triangle, and makes up for rounding errors while that helps.
/// Errors: solver_error if what is left is more than 1e-8; of solvers that iterate, relative to |b|, more than 1e-5.
template<class Solver>
Eigen::VectorXd solve_and_check(const Solver& solver, const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& b, const char* who,
                                bool is_lower_triangle = true) {
  Eigen::VectorXd x = solver.solve(b), r;
  double error = residual(a, x, b, r, is_lower_triangle);
  if (iterates(solver)) {
    error = relative_size(r, b);
    if (!(error <= 1e-5)) throw_not_solved(who, error);
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

}  // namespace concino::detail
