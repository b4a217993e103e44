// An iterative solver for symmetric positive definite sparse systems that are too large for a factorisation.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/system_checks.hpp>
#include <concino/solve/conjugate_gradients_options.hpp>
#include <concino/solve/detail/incomplete_cholesky.hpp>

#include <Eigen/SparseCore>

#include <cstdint>

namespace concino {

/// Solves symmetric positive definite systems by conjugate gradients, with an incomplete Cholesky factorisation as preconditioner. A SparseSolver with
/// memory proportional to the entries of the matrix. Reads only the lower triangle of the matrix. Scaling the matrix or the right-hand
/// side by a power of two scales the solution exactly. `factorize` stores a scaled copy of the matrix and the preconditioner; a matrix with the
/// pattern of the previous one reuses its order.
/// A solution x is accepted if both of these are at most the tolerance:
/// - error(), the estimated error of x in the energy norm, |x - x*|_A / |x*|_A, where |y|_A^2 = y.Ay. It is extrapolated from the gains of the last
///   iterations, commonly right within a factor of 10, and does not depend on the units of the unknowns;
/// - residual(), the largest |b - A x|_i / (|b|_i + a_ii max|x|) of all rows i. Large entries of some rows, such as penalties, do not hide the others. The
///   denominator uses the smaller of a_ii max|x| and its value in unknowns scaled to a diagonal of 1, sqrt(a_ii) max_j sqrt(a_jj)|x_j|.
/// If rounding errors allow no better, a residual() of at most 1e-14 and an error() of at most 1e-6 are accepted as well. Then x solves a system that
/// differs from the original one by rounding errors only, and is as good as the result of a factorisation.
/// iterations(), error(), residual() and has_converged() describe the last solve. So one object must not solve in several threads at once.
/// Errors: invalid_argument if an option is out of its range. factorize throws solver_error, with the reason, if the matrix is not square, or has
///         entries that are not finite, or a diagonal entry that is not positive. solve throws it if nothing was factorised, or the
///         right-hand side has another size or is not finite. solve also throws it if the tolerance is missed, after max_iterations or because the
///         iteration stagnates; the message contains iterations, error, residual and tolerance. Indefinite and singular matrices with a positive
///         diagonal fail in this way, unless the iteration finds a solution for that right-hand side.
/// Source: Hestenes, Stiefel 1952 (iteration, error estimate); Golub, Meurant 1997 (estimate with a delay); Meijerink, van der Vorst 1977.
class conjugate_gradients {
  conjugate_gradients_options options_;
  detail::elimination_order order_;
  core::sparsity_pattern pattern_;
  Eigen::SparseMatrix<double> a_;  // lower triangle, reordered and scaled
  double scale_ = 1;
  detail::incomplete_cholesky preconditioner_;
  mutable std::int64_t iterations_ = 0;
  mutable double residual_ = 0, error_ = 0;
  mutable bool has_converged_ = true;
  Eigen::Index size_ = -1;

 public:
  conjugate_gradients() = default;
  explicit conjugate_gradients(const conjugate_gradients_options& options);

  void factorize(const Eigen::SparseMatrix<double>& matrix);

  /// Whether this matrix has the pattern of the previous one, so that its order can be reused.
  bool has_pattern_of(const Eigen::SparseMatrix<double>& a) const { return a.isCompressed() && pattern_.is_of(a); }

  Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const;

  const conjugate_gradients_options& options() const { return options_; }
  static constexpr bool is_iterative() { return true; }
  int iterations() const { return static_cast<int>(iterations_); }
  double error() const { return error_; }
  double residual() const { return residual_; }
  bool has_converged() const { return has_converged_; }

 private:
  [[noreturn, gnu::cold]] void throw_missed() const;

  static double dot(const Eigen::VectorXd& x, const Eigen::VectorXd& y);

  struct products {
    double energy, diagonal;  // x.Ax, and the contribution of the diagonal to it
  };

  /// y = A x.
  products multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;

  /// The largest |r|_i / (|b|_i + a_ii max|x|), or its value with the unknowns scaled to a diagonal of 1, if that is larger for a row.
  double largest_residual(const Eigen::VectorXd& r, const Eigen::VectorXd& b, const Eigen::VectorXd& x) const;

  /// Iterates until the estimates of error and residual are small. Then computes the residual from x itself. If it differs, or the
  /// preconditioned residual shows a larger error, restarts the iteration from x, as long as that helps.
  void iterate(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/conjugate_gradients.ipp>
#endif
