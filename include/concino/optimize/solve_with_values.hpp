// Square linear systems with known values of some unknowns.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/residual.hpp>
#include <concino/optimize/detail/known_values.hpp>
#include <concino/solve/auto_solver.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace concino {

namespace detail {

/// The matrix with the rows and columns of known unknowns replaced by 1 in suitable units. Rows keep their numbers,
/// which solvers use in messages.
inline Eigen::SparseMatrix<double> without_known_values(const known_values& problem,
                                                        const Eigen::SparseMatrix<double>& a) {
  double largest = 0;
  for (Eigen::Index k = 0; k < a.nonZeros(); ++k) largest = std::max(largest, std::abs(a.valuePtr()[k]));
  Eigen::SparseMatrix<double> r(a.rows(), a.cols());
  r.resizeNonZeros(a.nonZeros() + a.cols());
  int at = 0;
  const auto put = [&](int row, double value) {
    r.innerIndexPtr()[at] = row;
    r.valuePtr()[at++] = value;
  };
  for (int c = 0; c < a.cols(); ++c) {
    if (problem.unknown[static_cast<std::size_t>(c)] < 0) {
      put(c, 1 / core::power_of_two_to_scale(largest));
    } else {
      for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k)
        if (const int row = a.innerIndexPtr()[k]; problem.unknown[static_cast<std::size_t>(row)] >= 0)
          put(row, a.valuePtr()[k]);
    }
    r.outerIndexPtr()[c + 1] = at;
  }
  r.resizeNonZeros(at);
  return r;
}

/// b minus the contributions of known unknowns; 0 in their rows.
inline Eigen::VectorXd load_of_unknowns(const known_values& problem, const Eigen::SparseMatrix<double>& a,
                                        Eigen::VectorXd b) {
  for (int c = 0; c < a.cols(); ++c)
    if (problem.unknown[static_cast<std::size_t>(c)] < 0)
      for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k)
        b[a.innerIndexPtr()[k]] -= a.valuePtr()[k] * problem.x[c];
  for (int c = 0; c < a.cols(); ++c)
    if (problem.unknown[static_cast<std::size_t>(c)] < 0) b[c] = 0;
  return b;
}

}  // namespace detail

/// The x with x_i = v for the pairs (i, v) of `known`, in braces or any container, and (A x)_j = b_j in all other rows
/// j. Rows and columns of known unknowns are removed and their contributions go to the right-hand side, so the system
/// stays symmetric or definite if it was.
/// Needs:  A: square, both triangles. solver: a SparseSolver: the default for symmetric positive definite matrices, lu
///         for others. Rows of known unknowns are ignored in A and b.
/// Result: x, with known values exact, solved until only rounding errors are left, which is checked; iterative solvers
///         solve to their tolerance.
/// Cost:   one factorisation of the reduced A.
/// Errors: solver_error if A is not square, b has another size, or an entry is not finite. solver_error, with the
///         reason and the row of A, if the solver cannot factorise the reduced A. solver_error if x does not solve the
///         system, as when A is not symmetric but the solver reads one triangle. invalid_argument if an index is out of
///         range, or a value is not finite or is given twice with different values.
template<class D = std::initializer_list<std::pair<Eigen::Index, double>>, class Solver = auto_solver>
  requires SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd> Eigen::VectorXd solve_with_values(
      const Eigen::SparseMatrix<double>& A, const Eigen::VectorXd& b, const D& known, Solver&& solver = {}) {
    const char* const caller = "solve_with_values";
    Eigen::SparseMatrix<double> storage;
    const Eigen::SparseMatrix<double>& a = core::compressed(A, storage);
    core::check_square(caller, a);
    core::check_entries(caller, a);
    core::check_right_hand_side(caller, b, a.rows());
    const detail::known_values problem(caller, a.cols(), known);
    if (problem.unknowns == 0) return problem.x;
    const Eigen::SparseMatrix<double> left = detail::without_known_values(problem, a);
    const Eigen::VectorXd load = detail::load_of_unknowns(problem, a, b);
    solver.factorize(left);
    Eigen::VectorXd x = core::solve_and_check(solver, left, load, caller, false);
    for (Eigen::Index i = 0; i < x.size(); ++i)
      if (problem.unknown[static_cast<std::size_t>(i)] < 0) x[i] = problem.x[i];
    return x;
  }

}  // namespace concino
