// The iteration of conjugate gradients; see conjugate_gradients.hpp.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/detail/energy_gains.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace concino {

CONCINO_INLINE conjugate_gradients::conjugate_gradients(const conjugate_gradients_options& options) : options_(options) {
  if (!(options.tolerance > 0 && options.tolerance < 1))
    core::throw_joined<invalid_argument>({"conjugate_gradients: tolerance is ", core::number_text(options.tolerance),
                                            "; it must be in (0, 1)"});
  if (options.max_iterations < 0) throw invalid_argument("conjugate_gradients: max_iterations is negative");
}

CONCINO_INLINE void conjugate_gradients::factorize(const Eigen::SparseMatrix<double>& matrix) {
  size_ = -1;
  Eigen::SparseMatrix<double> storage;
  const Eigen::SparseMatrix<double>& input = core::compressed(matrix, storage);
  core::check_square("conjugate_gradients", input);
  core::check_entries("conjugate_gradients", input);
  double largest = 0;
  const std::vector<double> diagonal = core::diagonal(input);
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    if (!(diagonal[i] > 0))
      throw core::singular_row(core::joined({"conjugate_gradients: the matrix is not positive definite: the diagonal entry of row ", i, " is ",
                                                 core::number_text(diagonal[i])}),
                                 static_cast<Eigen::Index>(i));
    largest = std::max(largest, diagonal[i]);
  }
  scale_ = core::power_of_two_to_scale(largest);
  pattern_.update(input, [&](const auto& m) { order_.keep(detail::breadth_first_order(m)); });
  a_ = detail::sorted_transpose(order_(input));
  for (Eigen::Index k = 0; k < a_.nonZeros(); ++k) a_.valuePtr()[k] *= scale_;
  preconditioner_.factorize(a_);
  size_ = input.rows();
}

CONCINO_INLINE Eigen::VectorXd conjugate_gradients::solve(const Eigen::VectorXd& rhs) const {
  core::check_right_hand_side("conjugate_gradients", rhs, size_);
  iterations_ = 0;
  residual_ = error_ = 0;
  has_converged_ = true;
  double largest = 0;
  for (Eigen::Index i = 0; i < rhs.size(); ++i) largest = std::max(largest, std::abs(rhs[i]));
  Eigen::VectorXd b(size_), x(size_);
  if (!(largest > 0)) {
    for (Eigen::Index i = 0; i < size_; ++i) x[i] = 0;
    return x;
  }
  const double b_scale = core::power_of_two_to_scale(largest);
  const int* const row = order_.row.data();
  for (Eigen::Index i = 0; i < size_; ++i) b[i] = rhs[row[i]] * b_scale;
  iterate(b, x);
  if (!has_converged_ && !options_.accept_missed_tolerance) throw_missed();
  for (Eigen::Index i = 0; i < size_; ++i) b[row[i]] = x[i] * scale_ / b_scale;
  core::check_solution("conjugate_gradients", b);
  return b;
}

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void conjugate_gradients::throw_missed() const {
  core::throw_joined<solver_error>({"conjugate_gradients: not converged after ", static_cast<std::size_t>(iterations_),
                                      " iterations: the error is estimated as ", core::number_text(error_), " of the solution, the residual is ",
                                      core::number_text(residual_), ", the tolerance ", core::number_text(options_.tolerance),
                                      "; the matrix is not positive definite, or badly conditioned: use ldlt, allow more iterations or a larger"
                                      " tolerance, or set accept_missed_tolerance"});
}

CONCINO_INLINE double conjugate_gradients::dot(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  double sum[4] = {};  // several, so that additions are independent
  const Eigen::Index n = x.size() / 4 * 4;
  for (Eigen::Index i = 0; i < n; i += 4)
    for (Eigen::Index k = 0; k < 4; ++k) sum[k] += x[i + k] * y[i + k];
  for (Eigen::Index i = n; i < x.size(); ++i) sum[0] += x[i] * y[i];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

CONCINO_INLINE conjugate_gradients::products conjugate_gradients::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  const auto n = static_cast<int>(a_.cols());
  const int *const starts = a_.outerIndexPtr(), *const rows = a_.innerIndexPtr();
  const double* const a = a_.valuePtr();
  products r{0, 0};
  for (int c = 0; c < n; ++c) y[c] = 0;
  for (int c = 0; c < n; ++c) {
    const double xc = x[c], on = a[starts[c]] * xc;
    double sum = 0;
    for (int k = starts[c] + 1; k < starts[c + 1]; ++k) {
      y[rows[k]] += a[k] * xc;
      sum += a[k] * x[rows[k]];
    }
    y[c] += on + sum;
    r.diagonal += on * xc;
    r.energy += (on + 2 * sum) * xc;
  }
  return r;
}

CONCINO_INLINE double conjugate_gradients::largest_residual(const Eigen::VectorXd& r, const Eigen::VectorXd& b, const Eigen::VectorXd& x) const {
  const int* const starts = a_.outerIndexPtr();
  const double* const a = a_.valuePtr();
  double largest = 0, largest_scaled = 0, worst = 0;
  for (Eigen::Index i = 0; i < size_; ++i) {
    const double xi = x[i] * x[i];
    largest = std::max(largest, xi);
    largest_scaled = std::max(largest_scaled, a[starts[i]] * xi);
  }
  largest = std::sqrt(largest);
  for (Eigen::Index i = 0; i < size_; ++i) {
    const double d = a[starts[i]], allowed = std::abs(b[i]) + std::min(d * largest, std::sqrt(d * largest_scaled));
    const double e = r[i] == 0 ? 0 : std::abs(r[i]) / allowed;
    if (e > worst || std::isnan(e)) worst = e;
  }
  return worst;
}

CONCINO_INLINE void conjugate_gradients::iterate(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  const double unknown = std::numeric_limits<double>::infinity(), wanted = options_.tolerance * options_.tolerance;
  const std::int64_t most = options_.max_iterations > 0 ? options_.max_iterations : 2 * static_cast<std::int64_t>(size_);
  const std::int64_t patience = 500 + 4 * static_cast<std::int64_t>(std::sqrt(static_cast<double>(size_)));
  Eigen::VectorXd r = b, z(size_), p(size_), q(size_);
  for (Eigen::Index i = 0; i < size_; ++i) x[i] = 0;
  detail::energy_gains gained;
  preconditioner_.solve(a_, r, z);
  double along = dot(r, z);  // |r|^2 in the norm of the preconditioner
  double left = unknown;     // the square of the error
  residual_ = 1;
  for (;;) {
    gained.start();
    const double first = along, residual_before = residual_, left_before = left;
    double smallest = along;
    std::int64_t of_smallest = iterations_;
    left = unknown;
    bool is_stuck = !(along > 0 && std::isfinite(along));
    for (double turn = 0; !is_stuck && iterations_ < most;) {
      for (Eigen::Index i = 0; i < size_; ++i) p[i] = turn == 0 ? z[i] : z[i] + turn * p[i];
      const products product = multiply(p, q);
      if (!(product.energy > 1e-16 * product.diagonal && std::isfinite(product.energy))) break;  // the matrix is not definite
      const double step = along / product.energy;
      for (Eigen::Index i = 0; i < size_; ++i) {
        x[i] += step * p[i];
        r[i] -= step * q[i];
      }
      ++iterations_;
      gained.add(step * along);
      left = gained.left();
      if (gained.is_exhausted() || (left <= wanted * gained.all() && largest_residual(r, b, x) <= options_.tolerance)) break;
      preconditioner_.solve(a_, r, z);
      const double before = along;
      along = dot(r, z);
      turn = along / before;
      if (along < smallest / 2) {
        smallest = along;
        of_smallest = iterations_;
      }
      is_stuck = !(along > 0 && std::isfinite(along)) || iterations_ - of_smallest > patience;
    }
    const double expected = along;
    multiply(x, q);
    for (Eigen::Index i = 0; i < size_; ++i) r[i] = b[i] - q[i];
    preconditioner_.solve(a_, r, z);
    along = dot(r, z);
    if (left == unknown) left = gained.has_any() ? gained.recent() : left_before;
    left = along == 0 ? 0 : left * std::max(1.0, along / expected);
    residual_ = largest_residual(r, b, x);
    error_ = gained.all() > 0 ? std::sqrt(left / gained.all()) : 1;
    has_converged_ = error_ <= options_.tolerance && residual_ <= options_.tolerance;
    if (has_converged_ || iterations_ >= most || !(along < first / 4 || residual_ < residual_before / 2)) break;
  }
  has_converged_ |= residual_ <= 1e-14 && error_ <= 1e-6;
}

}  // namespace concino
