// Quadratic programs: the minimum of a convex quadratic function under linear inequality constraints.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/optimize/detail/qp_solver.hpp>

#include <string>

namespace concino {

/// Minimises 1/2 x'Hx + g'x subject to low <= Ax <= high. Equal bounds give equality constraints; infinite bounds are
/// ignored; bounds of x are rows of A.
/// Needs:  H symmetric (both triangles) and positive semidefinite, n x n; g of n; A m x n; low <= high of m, which may
///         be -inf and +inf.
/// Result: see qp_result. `status` says whether the minimum was found. Infeasible and unbounded programs are
///         recognised, with a certificate that can be checked by hand. Programs with equations only are solved by one
///         factorisation. Others by operator splitting with one factorisation (a few more if its weights change), then,
///         with `polish`, exactly for the active bounds.
/// Cost:   a factorisation of n + m unknowns, and one substitution per iteration; some ten to some thousand iterations.
/// Errors: invalid_argument if sizes do not fit, a number is not finite (bounds may be infinite), some low > high, H is
///         not symmetric, or an option is out of range. solver_error if H is not positive semidefinite, or numbers grow
///         too large. cancelled.
/// Source: Stellato, Banjac, Goulart, Bemporad, Boyd 2020, "OSQP: an operator splitting solver for quadratic programs";
///         paper section 4.
inline qp_result solve_qp(const Eigen::SparseMatrix<double>& h, const Eigen::VectorXd& g,
                          const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& low, const Eigen::VectorXd& high,
                          const qp_options& input_options = {}) {
  const core::profiled_options profiled(input_options, "solve_qp");
  const qp_options& options = *profiled;
  const auto refuse = [](const char* what) { core::throw_joined<invalid_argument>({"quadratic program: ", what}); };
  const auto finite = [](const Eigen::SparseMatrix<double>& m) {
    for (int c = 0; c < m.outerSize(); ++c)
      for (Eigen::SparseMatrix<double>::InnerIterator it(m, c); it; ++it)
        if (!std::isfinite(it.value())) return false;
    return true;
  };
  if (h.rows() != h.cols() || h.cols() != g.size()) refuse("H must have as many rows and columns as g has entries");
  if (a.cols() != g.size()) refuse("A must have as many columns as g has entries");
  if (a.rows() != low.size() || a.rows() != high.size())
    refuse("A must have as many rows as there are lower and upper bounds");
  if (!finite(h) || !finite(a) || !g.allFinite()) refuse("H, A and g must be finite");
  const Eigen::SparseMatrix<double> transposed = h.transpose();
  if (h.cols() > 0 && (h - transposed).norm() > 1e-12 * h.norm()) refuse("H must be symmetric");
  for (Eigen::Index i = 0; i < low.size(); ++i)
    if (!(low[i] <= high[i]) || low[i] == std::numeric_limits<double>::infinity() ||
        high[i] == -std::numeric_limits<double>::infinity())
      core::throw_joined<invalid_argument>({"quadratic program: row ", static_cast<std::size_t>(i),
                                            " has the lower bound ", core::number_text(low[i]), " and the upper bound ",
                                            core::number_text(high[i]), "; no finite number lies between them"});
  if (!(options.tolerance >= 1e-12 && options.tolerance <= 1)) refuse("tolerance must be from 1e-12 to 1");
  if (options.max_iterations < 1) refuse("max_iterations must be 1 or more");
  if (options.x.size() && (options.x.size() != g.size() || !options.x.allFinite()))
    refuse("the initial x must be finite and of the size of g");
  if (options.multipliers.size() && (options.multipliers.size() != low.size() || !options.multipliers.allFinite()))
    refuse("the initial multipliers must be finite, one for each row of A");
  return detail::qp_solver(h, g, a, low, high, options).solve();
}

}  // namespace concino
