// Symmetric positive definite sparse systems by iteration: what is too large for a factorisation.
#pragma once

#include <concino/solve/detail/incomplete_cholesky.hpp>
#include <concino/solve/detail/system_checks.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace concino {

struct conjugate_gradients_options {
  double tolerance = 1e-12;  // of |b - a x| / |b|; in (0, 1)
  int max_iterations = 0;    // 0: twice as many as there are unknowns
};

/// Solves symmetric positive definite systems by conjugate gradients, with an incomplete Cholesky factorisation to speed them up. A SparseSolver of
/// memory proportional to the entries of the matrix. Only the lower triangle of the matrix is read. Scaling the matrix or the right-hand
/// side by a power of two scales the solution exactly. `factorize` keeps a scaled copy of the matrix and prepares; of a matrix with the pattern of
/// the one before, in the order found then.
/// iterations() and residual(), |b - a x| / |b|, tell of the last solve; therefore not for several threads at once.
/// Errors: invalid_argument if an option is out of its range; solver_error, with the reason, from factorize if the matrix is not square, has
///         entries that are not finite, or a diagonal entry that is not positive; from solve if nothing was factorised, or the right-hand side
///         has another size or is not finite, or the iteration has not converged: n iterations and residual r are named. Indefinite
///         and singular matrices with a positive diagonal end so, unless the iteration happens to find a solution. Where rounding errors hide
///         what the last iterations gain, residuals of up to 1e-6 are let pass; residual() tells.
/// Source: Hestenes, Stiefel 1952; Meijerink, van der Vorst 1977.
class conjugate_gradients {
  conjugate_gradients_options options_;
  detail::elimination_order order_;
  detail::sparsity_pattern pattern_;
  Eigen::SparseMatrix<double> a_;  // lower triangle, reordered and scaled
  double scale_ = 1;
  detail::incomplete_cholesky near_a_;
  mutable std::int64_t iterations_ = 0;
  mutable double residual_ = 0;
  Eigen::Index size_ = -1;

 public:
  conjugate_gradients() = default;
  explicit conjugate_gradients(const conjugate_gradients_options& options) : options_(options) {
    if (!(options.tolerance > 0 && options.tolerance < 1))
      detail::throw_joined<invalid_argument>({"conjugate_gradients: tolerance is ", detail::number_text(options.tolerance),
                                              "; it must be in (0, 1)"});
    if (options.max_iterations < 0) throw invalid_argument("conjugate_gradients: max_iterations is negative");
  }

  void factorize(const Eigen::SparseMatrix<double>& matrix) {
    size_ = -1;
    Eigen::SparseMatrix<double> storage;
    const Eigen::SparseMatrix<double>& given = detail::compressed(matrix, storage);
    detail::check_square("conjugate_gradients", given);
    detail::check_entries("conjugate_gradients", given);
    double largest = 0;
    const std::vector<double> diagonal = detail::diagonal(given);
    for (std::size_t i = 0; i < diagonal.size(); ++i) {
      if (!(diagonal[i] > 0))
        detail::throw_joined<solver_error>({"conjugate_gradients: the matrix is not positive definite: the diagonal entry of row ", i, " is ",
                                            detail::number_text(diagonal[i])});
      largest = std::max(largest, diagonal[i]);
    }
    scale_ = detail::power_of_two_to_scale(largest);
    pattern_.update(given, [&](const auto& m) { order_.keep(detail::breadth_first_order(m)); });
    a_ = detail::sorted_transpose(order_(given));
    for (Eigen::Index k = 0; k < a_.nonZeros(); ++k) a_.valuePtr()[k] *= scale_;
    near_a_.factorize(a_);
    size_ = given.rows();
  }

  /// Whether the pattern of this matrix is that of the last, so that no order has to be found for it.
  bool has_pattern_of(const Eigen::SparseMatrix<double>& a) const { return a.isCompressed() && pattern_.is_of(a); }

  Eigen::VectorXd solve(const Eigen::VectorXd& given) const {
    detail::check_right_hand_side("conjugate_gradients", given, size_);
    iterations_ = 0;
    residual_ = 0;
    double largest = 0;
    for (Eigen::Index i = 0; i < given.size(); ++i) largest = std::max(largest, std::abs(given[i]));
    if (!(largest > 0)) return Eigen::VectorXd::Zero(size_);
    const double b_scale = detail::power_of_two_to_scale(largest);
    Eigen::VectorXd b(size_), x(size_);
    const int* const row = order_.row.indices().data();
    for (Eigen::Index i = 0; i < size_; ++i) b[i] = given[row[i]] * b_scale;
    if (!iterate(b, x))
      detail::throw_joined<solver_error>({"conjugate_gradients: not converged after ", static_cast<std::size_t>(iterations_),
                                          " iterations: the residual is ",
                                          detail::number_text(residual_), ", the tolerance ", detail::number_text(options_.tolerance),
                                          "; the matrix is not positive definite, or badly conditioned"});
    for (Eigen::Index i = 0; i < size_; ++i) b[row[i]] = x[i] * scale_ / b_scale;
    detail::check_solution("conjugate_gradients", b);
    return b;
  }

  const conjugate_gradients_options& options() const { return options_; }
  static constexpr bool iterates() { return true; }
  int iterations() const { return static_cast<int>(iterations_); }
  double residual() const { return residual_; }

 private:
  static double dot(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
    double sum[4] = {};  // several, so that additions need not wait for each other
    const Eigen::Index n = x.size() / 4 * 4;
    for (Eigen::Index i = 0; i < n; i += 4)
      for (Eigen::Index k = 0; k < 4; ++k) sum[k] += x[i + k] * y[i + k];
    for (Eigen::Index i = n; i < x.size(); ++i) sum[0] += x[i] * y[i];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
  }

  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
    const auto n = static_cast<int>(a_.cols());
    const int *const starts = a_.outerIndexPtr(), *const rows = a_.innerIndexPtr();
    const double* const a = a_.valuePtr();
    for (int c = 0; c < n; ++c) y[c] = a[starts[c]] * x[c];
    for (int c = 0; c < n; ++c) {
      const double xc = x[c];
      double sum = 0;
      for (int k = starts[c] + 1; k < starts[c + 1]; ++k) {
        y[rows[k]] += a[k] * xc;
        sum += a[k] * x[rows[k]];
      }
      y[c] += sum;
    }
  }

  /// Result: whether x solves, by the residual computed from x itself, which the iteration only estimates: where they differ it starts afresh from x
  /// as long as that helps.
  bool iterate(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
    const std::int64_t most = options_.max_iterations > 0 ? options_.max_iterations : 2 * static_cast<std::int64_t>(size_);
    const double size_of_b = std::sqrt(dot(b, b)), wanted = options_.tolerance * size_of_b;
    Eigen::VectorXd r = b, z(size_), p(size_), q(size_);
    x.setZero();
    residual_ = 1;
    for (;;) {
      double along = 0;  // r.z
      bool falls = true;
      for (bool first = true; falls && iterations_ < most && !(std::sqrt(dot(r, r)) <= wanted); first = false) {
        near_a_.solve(a_, r, z);
        const double before = along;
        along = dot(r, z);
        const double turn = first ? 0 : along / before;
        for (Eigen::Index i = 0; i < size_; ++i) p[i] = first ? z[i] : z[i] + turn * p[i];
        multiply(p, q);
        const double curvature = dot(p, q);
        falls = curvature > 0 && std::isfinite(curvature);
        if (!falls) break;
        const double step = along / curvature;
        for (Eigen::Index i = 0; i < size_; ++i) {
          x[i] += step * p[i];
          r[i] -= step * q[i];
        }
        ++iterations_;
      }
      multiply(x, q);
      for (Eigen::Index i = 0; i < size_; ++i) r[i] = b[i] - q[i];
      const double last = residual_;
      residual_ = std::sqrt(dot(r, r)) / size_of_b;
      if (!falls || iterations_ >= most || residual_ <= options_.tolerance || !(residual_ < last / 2))
        return residual_ <= options_.tolerance || (residual_ <= 1e-6 && iterations_ < most);
    }
  }
};

}  // namespace concino
