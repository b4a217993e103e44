// Whether a computed solution solves: the residual of a symmetric system, measured against what rounding errors allow, and improved.
#pragma once

#include <concino/detail/number_text.hpp>
#include <concino/error.hpp>

#include <Eigen/SparseCore>

#include <cmath>
#include <string>

namespace concino::detail {

/// r = b - a x for a symmetric matrix given by its lower triangle.
/// Result: the largest |r_i| / (|a| |x| + |b|)_i: the relative change of matrix and right-hand side that would make x exact. It does not
///         depend on the scale of rows.
inline double residual(const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& x, const Eigen::VectorXd& b, Eigen::VectorXd& r) {
  Eigen::VectorXd scale = b.cwiseAbs();
  r = b;
  for (Eigen::Index c = 0; c < lower.cols(); ++c) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(lower, c); it; ++it) {
      const double below = it.value() * x[c];
      r[it.row()] -= below;
      scale[it.row()] += std::abs(below);
      if (it.row() == c) continue;
      const double above = it.value() * x[it.row()];
      r[c] -= above;
      scale[c] += std::abs(above);
    }
  }
  double worst = 0;
  for (Eigen::Index i = 0; i < r.size(); ++i) {
    const double e = r[i] == 0 ? 0 : std::abs(r[i]) / scale[i];
    if (!(e <= worst)) worst = e;
  }
  return worst;
}

/// Solves with a factorised matrix and makes up for rounding errors while that helps.
/// Errors: solver_error if what is left is more than 1e-8.
template<class Solver>
Eigen::VectorXd solve_and_check(const Solver& solver, const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& b, const char* who) {
  Eigen::VectorXd x = solver.solve(b), r;
  double error = residual(lower, x, b, r);
  for (int round = 0; round < 3 && error > 1e-13; ++round) {
    const Eigen::VectorXd better = x + solver.solve(r);
    const double left = residual(lower, better, b, r);
    if (!(left < error)) break;
    x = better;
    error = left;
  }
  if (!(error <= 1e-8))
    throw solver_error(std::string(who) + ": the system is too badly conditioned for double precision: the relative residual is " + number_text(error));
  return x;
}

}  // namespace concino::detail
