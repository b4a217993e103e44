// Sparse linear least squares, with known values of some unknowns.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/equilibrate.hpp>
#include <concino/optimize/detail/known_values.hpp>
#include <concino/solve/auto_solver.hpp>
#include <concino/solve/qr.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

namespace requirement {

/// A solver for matrices with more rows than columns, as qr is.
template<class S> concept solves_least_squares = requires { requires std::remove_cvref_t<S>::solves_least_squares; };

}  // namespace requirement

struct least_squares_result {
  Eigen::VectorXd x;
  double residual = 0;   // |b - A x|, or the root of sum w_i (b - A x)_i^2
  bool used_qr = false;  // whether qr was used, also because another solver lost too many digits
};

namespace detail {

/// The maximum number of unknowns for qr; for more its factor may be too large.
inline constexpr Eigen::Index max_unknowns_of_qr = 10'000;

/// Solves the normal equations of j y = b, then for the remainder as long as that helps. With a condition number K of
/// j, each correction multiplies the error by K^2 times the rounding unit e, down to about K e + K^2 e |r| / |y|, as in
/// orthogonal factorisation.
/// Result: whether corrections decreased, and enough. If the first is not small, K^2 e is not small, and digits are
///         lost that corrections cannot recover.
/// Errors: those of the solver.
template<class Solver>
bool solve_normal_equations(const Eigen::SparseMatrix<double>& j, const Eigen::VectorXd& b, Solver& solver,
                            Eigen::VectorXd& y) {
  const double unit = std::numeric_limits<double>::epsilon();
  const Eigen::SparseMatrix<double> transposed = j.transpose();
  const Eigen::SparseMatrix<double> normal = transposed * j;
  solver.factorize(normal);
  y = solver.solve(Eigen::VectorXd(transposed * b));
  double first = 0, last = y.norm();
  for (int step = 0; step < 12; ++step) {
    const Eigen::VectorXd r = b - j * y, correction = solver.solve(Eigen::VectorXd(transposed * r));
    const double size = correction.norm(), whole = y.norm();
    if (step == 0) first = whole > 0 ? std::max(size / whole, unit) : unit;
    const double reachable = 64 * (std::sqrt(first * unit) * whole + first * r.norm());
    if (!(size < last)) return first <= 0.01 && last <= reachable;
    y += correction;
    if (size <= unit * whole) break;
    if (size > last / 4) return first <= 0.01 && size <= reachable;
    last = size;
  }
  return first <= 0.01;
}

template<class D, class Solver>
least_squares_result least_squares(const char* caller, Eigen::SparseMatrix<double> a, Eigen::VectorXd b, const D& known,
                                   Solver& solver) {
  a.makeCompressed();
  core::check_entries(caller, a);
  core::check_right_hand_side(caller, b, a.rows());
  const known_values problem(caller, a.cols(), known);
  Eigen::SparseMatrix<double> j = problem.columns_of_unknowns(a);
  b -= a * problem.x;
  const std::vector<double> scale = core::scale_columns(j);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(j.cols());
  bool used_qr = false;
  if (j.cols() > 0) {
    if constexpr (requirement::solves_least_squares<Solver>) {
      solver.factorize(j);
      y = solver.solve(b);
      used_qr = std::same_as<std::remove_cvref_t<Solver>, qr>;
    } else {
      const bool may_use_qr = j.cols() <= max_unknowns_of_qr;
      try {
        used_qr = !solve_normal_equations(j, b, solver, y);
      } catch (const solver_error&) {
        if (!may_use_qr) throw;
        used_qr = true;
      }
      if (used_qr && !may_use_qr)
        core::throw_joined<solver_error>(
            {caller,
             ": the columns of the matrix are nearly dependent, so the normal equations lose too many digits, and ",
             static_cast<std::size_t>(j.cols()),
             " unknowns are too many for the automatic use of qr; pass qr as the solver, or add conditions"});
      if (used_qr) {
        qr orthogonal;
        orthogonal.factorize(j);
        y = orthogonal.solve(b);
      }
    }
  }
  const double residual = (b - j * y).norm();
  return {problem.with(core::scaled(std::move(y), scale)), residual, used_qr};
}

}  // namespace detail

/// Minimises |A x - b| over all x with x_i = v for the pairs (i, v) of `known`, in braces or any container.
/// Needs:  A: any shape, but the columns of its unknowns are independent. solver: a SparseSolver for positive definite
///         matrices, which gets the normal equations. Columns are scaled, and the result is corrected until only
///         rounding errors are left (Bjorck 1987). Or qr, which gets A. If columns are nearly dependent, so that
///         corrections do not decrease, qr is used automatically, up to 10,000 unknowns.
/// Result: x, with known values exact, the residual |A x - b|, and whether qr was used.      Cost: one factorisation of
///         A^T A, or of A, or both.
/// Errors: solver_error if A has entries that are not finite, or columns that depend on others (beyond 10,000 unknowns:
///         or nearly so). solver_error if b has another size or entries that are not finite. invalid_argument if an
///         index is out of range, or a value is not finite or is given twice with different values.
/// Source: Bjorck 1987 (corrected semi-normal equations).
template<class D = std::initializer_list<std::pair<Eigen::Index, double>>, class Solver = auto_solver>
  requires SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd> least_squares_result least_squares(
      const Eigen::SparseMatrix<double>& A, const Eigen::VectorXd& b, const D& known = {}, Solver&& solver = {}) {
    return detail::least_squares("least_squares", A, b, known, solver);
  }

/// Weighted least squares, with a weight w_i per row: minimises sum w_i (A x - b)_i^2. Rows of weight 0 are ignored.
/// Needs:  as least_squares, of A with each row multiplied by the square root of its weight; w: one number per row,
///         finite, 0 or more.
/// Result: as least_squares; the residual is the square root of the sum.      Cost: as least_squares.
/// Errors: as least_squares; invalid_argument if w has another size than A has rows, or a weight is negative or not
///         finite.
template<class D = std::initializer_list<std::pair<Eigen::Index, double>>, class Solver = auto_solver>
  requires SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd> least_squares_result
  weighted_least_squares(const Eigen::SparseMatrix<double>& A, const Eigen::VectorXd& w, const Eigen::VectorXd& b,
                         const D& known = {}, Solver&& solver = {}) {
    const char* const caller = "weighted_least_squares";
    if (w.size() != A.rows())
      core::throw_joined<invalid_argument>({caller, ": there are ", static_cast<std::size_t>(w.size()),
                                            " weights, but ", static_cast<std::size_t>(A.rows()), " rows"});
    for (Eigen::Index i = 0; i < w.size(); ++i)
      if (!(w[i] >= 0 && std::isfinite(w[i])))
        core::throw_joined<invalid_argument>({caller, ": the weight of row ", static_cast<std::size_t>(i), " is ",
                                              core::number_text(w[i]), "; weights must be finite and not negative"});
    core::check_right_hand_side(caller, b, A.rows());
    const Eigen::VectorXd root = w.cwiseSqrt();
    return detail::least_squares(caller, root.asDiagonal() * A, root.cwiseProduct(b), known, solver);
  }

}  // namespace concino
