// Residuals of solutions; see residual.hpp.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/residual.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace concino::core {

CONCINO_INLINE double residual(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& x, const Eigen::VectorXd& b,
                               Eigen::VectorXd& r, bool is_lower_triangle) {
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

CONCINO_INLINE double residual_beside_largest(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& x,
                                              const Eigen::VectorXd& b, const Eigen::VectorXd& r,
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

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_not_solved(const char* caller, double error) {
  core::throw_joined<solver_error>(
      {caller,
       ": the system is too badly conditioned for double precision, or the solver is not made for such a system:"
       " the relative residual is ",
       core::number_text(error)});
}

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_singular_at_vert(const char* caller, std::size_t vert,
                                                                                  const char* why) {
  core::throw_joined<solver_error>(
      {caller, ": the system is singular to working precision at vert ", vert,
       ": polys near it are too flat or too thin for double precision; remesh them, scale the mesh to more even lengths, or"
       " remove them (",
       why, ")"});
}

CONCINO_INLINE Eigen::VectorXd solve_and_check(solver_ref solver, const Eigen::SparseMatrix<double>& a,
                                               const Eigen::VectorXd& b, const char* caller, bool is_lower_triangle) {
  Eigen::VectorXd x = solver.solve(b), r;
  double error = residual(a, x, b, r, is_lower_triangle);
  if (solver.is_iterative()) {
    error = residual_beside_largest(a, x, b, r, is_lower_triangle);
    if (!(error <= std::max(1e-5, 10 * solver.residual()))) throw_not_solved(caller, error);
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
  if (!(error <= 1e-8)) throw_not_solved(caller, error);
  return x;
}

}  // namespace concino::core
