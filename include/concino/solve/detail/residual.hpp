// Whether a computed solution solves: the residual of a symmetric system, measured against what rounding errors allow, and improved.
#pragma once

#include <concino/detail/number_text.hpp>
#include <concino/error.hpp>

#include <Eigen/SparseCore>

#include <cmath>
#include <concepts>
#include <string>
#include <vector>

namespace concino::detail {

/// r = b - a x for a symmetric matrix given by its lower triangle, compressed. Loops, because Eigen's expressions take long to compile.
/// Result: the largest |r_i| / (|a| |x| + |b|)_i: the relative change of matrix and right-hand side that would make x exact. It does not
///         depend on the scale of rows.
inline double residual(const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& x, const Eigen::VectorXd& b, Eigen::VectorXd& r) {
  const auto n = static_cast<int>(lower.cols());
  std::vector<double> scale(static_cast<std::size_t>(n));
  double* const s = scale.data();
  r.resize(n);
  for (int i = 0; i < n; ++i) {
    r[i] = b[i];
    s[i] = std::abs(b[i]);
  }
  for (int c = 0; c < n; ++c) {
    for (int k = lower.outerIndexPtr()[c]; k < lower.outerIndexPtr()[c + 1]; ++k) {
      const int row = lower.innerIndexPtr()[k];
      const double below = lower.valuePtr()[k] * x[c];
      r[row] -= below;
      s[row] += std::abs(below);
      if (row == c) continue;
      const double above = lower.valuePtr()[k] * x[row];
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

/// Solves with a factorised matrix and makes up for rounding errors while that helps.
/// Errors: solver_error if what is left is more than 1e-8; of solvers that iterate, their own.
template<class Solver>
Eigen::VectorXd solve_and_check(const Solver& solver, const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& b, const char* who) {
  Eigen::VectorXd x = solver.solve(b), r;
  if (iterates(solver)) return x;
  double error = residual(lower, x, b, r);
  for (int round = 0; round < 3 && error > 1e-13; ++round) {
    Eigen::VectorXd better = solver.solve(r);
    for (Eigen::Index i = 0; i < x.size(); ++i) better[i] += x[i];
    const double left = residual(lower, better, b, r);
    if (!(left < error)) break;
    x.swap(better);
    error = left;
  }
  if (!(error <= 1e-8))
    throw solver_error(std::string(who) + ": the system is too badly conditioned for double precision: the relative residual is " +
                       number_text(error));
  return x;
}

}  // namespace concino::detail
