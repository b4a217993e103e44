// An iterative solver for symmetric positive definite sparse systems that are too large for a factorisation.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/solve/conjugate_gradients_options.hpp>
#include <concino/solve/detail/iterative/incomplete_cholesky.hpp>
#include <concino/solve/detail/iterative/iterative_system.hpp>

#include <Eigen/SparseCore>

namespace concino {

/// Solves symmetric positive definite systems by conjugate gradients, with an incomplete Cholesky factorisation as
/// preconditioner. A SparseSolver with memory proportional to the entries of the matrix. Reads only the lower triangle
/// of the matrix. Scaling the matrix or the right-hand side by a power of two scales the solution exactly. `factorize`
/// stores a scaled copy of the matrix and the preconditioner; a matrix with the pattern of the previous one reuses its
/// order. A solution x is accepted if both of these are at most the tolerance:
/// - error(), the estimated error of x in the energy norm, |x - x*|_A / |x*|_A, where |y|_A^2 = y.Ay. It is
///   extrapolated from the gains of the last iterations, commonly right within a factor of 10, and does not depend on
///   the units of the unknowns. Penalties do not count in |x*|_A: of a row whose diagonal entry is more than ten times
///   the sum of its other entries, only that sum counts, unless all rows are so;
/// - residual(), the largest |b - A x|_i / (|b|_i + a_ii max|x|) of all rows i. Large entries of some rows, such as
///   penalties, do not hide the others. The denominator uses the smaller of a_ii max|x| and its value in unknowns
///   scaled to a diagonal of 1, sqrt(a_ii) max_j sqrt(a_jj)|x_j|.
/// If rounding errors allow no better, a residual() of at most 1e-14 and an error() of at most 1e-6 are accepted as
/// well; or both of at most the tolerance, if penalties count. Then x solves a system that differs from the original
/// one by rounding errors only, and is as good as the result of a factorisation. iterations(), error(), residual() and
/// has_converged() describe the last solve. So one object must not solve in several threads at once.
/// Errors: invalid_argument if an option is out of its range. factorize throws solver_error, with the reason, if the
///         matrix is not square, or has entries that are not finite, or a diagonal entry that is not positive. solve
///         throws it if nothing was factorised, or the right-hand side has another size or is not finite. solve also
///         throws it if the tolerance is missed, after max_iterations or because the iteration stagnates; the message
///         contains iterations, error, residual and tolerance. Indefinite and singular matrices with a positive
///         diagonal fail in this way, unless the iteration finds a solution for that right-hand side.
/// Source: Hestenes, Stiefel 1952 (iteration, error estimate); Golub, Meurant 1997 (estimate with a delay); Meijerink,
///         van der Vorst 1977.
class conjugate_gradients {
  conjugate_gradients_options options_;
  detail::iterative_system system_;
  Eigen::SparseMatrix<double> a_;  // lower triangle, reordered and scaled
  detail::incomplete_cholesky preconditioner_;
  mutable detail::iteration_report report_;

 public:
  conjugate_gradients() = default;
  explicit conjugate_gradients(const conjugate_gradients_options& options);

  void factorize(const Eigen::SparseMatrix<double>& matrix);

  /// Whether this matrix has the pattern of the previous one, so that its order can be reused.
  bool has_pattern_of(const Eigen::SparseMatrix<double>& a) const { return system_.has_pattern_of(a); }

  Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const;

  const conjugate_gradients_options& options() const { return options_; }
  static constexpr bool is_iterative() { return true; }
  int iterations() const { return static_cast<int>(report_.iterations); }
  double error() const { return report_.error; }
  double residual() const { return report_.residual; }
  bool has_converged() const { return report_.has_converged; }
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/iterative/conjugate_gradients.ipp>
#endif
