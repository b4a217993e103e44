// Symmetric positive definite sparse systems by iteration: what is too large for a factorisation.
#pragma once

#include <concino/solve/detail/system_checks.hpp>

#include <Eigen/IterativeLinearSolvers>

#include <algorithm>
#include <cmath>
#include <vector>

namespace concino {

struct conjugate_gradients_options {
  double tolerance = 1e-12;  // of |b - a x| / |b|; in (0, 1)
  int max_iterations = 0;    // 0: twice as many as there are unknowns
};

/// Solves symmetric positive definite systems by conjugate gradients, with an incomplete Cholesky factorisation to speed them up. A SparseSolver of
/// memory proportional to the entries of the matrix. Only the lower triangle of the matrix is read. Scaling the matrix or the right-hand
/// side by a power of two scales the solution exactly. `factorize` keeps a scaled copy of the matrix and prepares: there is no analysis to save.
/// iterations() and residual(), |b - a x| / |b|, tell of the last solve; therefore not for several threads at once.
/// Errors: invalid_argument if an option is out of its range; solver_error, with the reason, from factorize if the matrix is not square, has
///         entries that are not finite, or a diagonal entry that is not positive; from solve if nothing was factorised, or the right-hand side
///         has another size or is not finite, or the iteration has not converged: n iterations and residual r are named. Indefinite
///         and singular matrices with a positive diagonal end so, unless the iteration happens to find a solution. Where rounding errors hide
///         what the last iterations gain, residuals of up to 1e-6 are let pass; residual() tells.
/// Source: Hestenes, Stiefel 1952; Lin, More 1999; Eigen's ConjugateGradient and IncompleteCholesky.
class conjugate_gradients {
  using matrix = Eigen::SparseMatrix<double>;
  conjugate_gradients_options options_;
  matrix a_;  // the iteration refers to it
  double scale_ = 1;
  Eigen::ConjugateGradient<matrix, Eigen::Lower, Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::AMDOrdering<int>>> iteration_;
  mutable int iterations_ = 0;
  mutable double residual_ = 0;
  Eigen::Index size_ = -1;

 public:
  explicit conjugate_gradients(const conjugate_gradients_options& options = {}) : options_(options) {
    if (!(options.tolerance > 0 && options.tolerance < 1))
      detail::throw_joined<invalid_argument>({"conjugate_gradients: tolerance is ", detail::number_text(options.tolerance),
                                              "; it must be in (0, 1)"});
    if (options.max_iterations < 0) throw invalid_argument("conjugate_gradients: max_iterations is negative");
  }

  void factorize(const Eigen::SparseMatrix<double>& given) {
    size_ = -1;
    a_ = given;
    a_.makeCompressed();
    detail::check_square("conjugate_gradients", a_);
    detail::check_entries("conjugate_gradients", a_);
    double largest = 0;
    const std::vector<double> diagonal = detail::diagonal(a_);
    for (std::size_t i = 0; i < diagonal.size(); ++i) {
      if (!(diagonal[i] > 0))
        detail::throw_joined<solver_error>({"conjugate_gradients: the matrix is not positive definite: the diagonal entry of row ", i, " is ",
                                            detail::number_text(diagonal[i])});
      largest = std::max(largest, diagonal[i]);
    }
    scale_ = detail::power_of_two_to_scale(largest);
    for (Eigen::Index k = 0; k < a_.nonZeros(); ++k) a_.valuePtr()[k] *= scale_;
    if (a_.cols() > 0) {
      iteration_.compute(a_);
      if (iteration_.info() != Eigen::Success)
        throw solver_error("conjugate_gradients: the incomplete Cholesky factorisation failed; the matrix is not positive definite");
      iteration_.setTolerance(options_.tolerance);
      iteration_.setMaxIterations(options_.max_iterations > 0 ? options_.max_iterations : 2 * a_.cols());
    }
    size_ = a_.rows();
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    detail::check_right_hand_side("conjugate_gradients", b, size_);
    iterations_ = 0;
    residual_ = 0;
    if (b.isZero(0)) return Eigen::VectorXd::Zero(size_);
    const double b_scale = detail::power_of_two_to_scale(b.cwiseAbs().maxCoeff());
    Eigen::VectorXd x = iteration_.solve(b * b_scale);
    iterations_ = static_cast<int>(iteration_.iterations());
    residual_ = (b * b_scale - a_.selfadjointView<Eigen::Lower>() * x).norm() / (b * b_scale).norm();  // the iteration's own is only estimated
    if (iteration_.info() != Eigen::Success || !(residual_ <= std::max(options_.tolerance, 1e-6)))
      detail::throw_joined<solver_error>({"conjugate_gradients: not converged after ", static_cast<std::size_t>(iterations_),
                                          " iterations: the residual is ",
                                          detail::number_text(residual_), ", the tolerance ", detail::number_text(options_.tolerance),
                                          "; the matrix is not positive definite, or badly conditioned"});
    x *= scale_;
    x /= b_scale;
    detail::check_solution("conjugate_gradients", x);
    return x;
  }

  int iterations() const { return iterations_; }
  double residual() const { return residual_; }
};

}  // namespace concino
