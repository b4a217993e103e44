// The iteration of conjugate gradients with any preconditioner, and its stopping rule.
#pragma once

#include <concino/core/function_ref.hpp>
#include <concino/solve/detail/iterative/energy_gains.hpp>
#include <concino/solve/detail/iterative/iteration_report.hpp>
#include <concino/solve/detail/iterative/penalty_rows.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace concino::detail {

/// Solves A x = b by conjugate gradients. A is passed as its lower triangle; each column begins with its diagonal
/// entry, which is positive.
/// Source: Hestenes, Stiefel 1952.
class preconditioned_iteration : public iteration_report {
  const Eigen::SparseMatrix<double>& a_;
  double tolerance_;
  std::int64_t max_iterations_, patience_;
  std::vector<double> diagonal_;
  std::optional<penalty_rows> penalties_;  // found when they are first asked for

  struct products {
    double energy, diagonal;  // p.Ap, and the contribution of the diagonal to it
  };

 public:
  /// patience: the number of iterations without progress after which the iteration stops.
  preconditioned_iteration(const Eigen::SparseMatrix<double>& a, double tolerance, std::int64_t max_iterations,
                           std::int64_t patience)
      : a_(a), tolerance_(tolerance),
        max_iterations_(max_iterations > 0 ? max_iterations : 2 * static_cast<std::int64_t>(a.cols())),
        patience_(patience), diagonal_(static_cast<std::size_t>(a.cols())) {
    for (std::size_t i = 0; i < diagonal_.size(); ++i) diagonal_[i] = a.valuePtr()[a.outerIndexPtr()[i]];
  }

  /// precondition(r, z, y) sets z to an approximate solution of A z = r. Returns whether it has set y to A z.
  /// Iterates until the estimates of error and residual are small. The error is compared with the energy of x without
  /// penalties. Then computes the residual from x itself. If it differs, or the preconditioned residual shows a larger
  /// error, restarts the iteration from x, as long as that helps.
  void run(const Eigen::VectorXd& b, Eigen::VectorXd& x,
           function_ref<bool(const Eigen::VectorXd&, Eigen::VectorXd&, Eigen::VectorXd&)> precondition) {
    const double unknown = std::numeric_limits<double>::infinity();
    const Eigen::Index n = a_.cols();
    Eigen::VectorXd r = b, z(n), y(n), p(n), q(n);  // y = A z, q = A p
    for (Eigen::Index i = 0; i < n; ++i) x[i] = 0;
    energy_gains gained;
    bool has_product = precondition(r, z, y);
    double along = dot(r, z);  // |r|^2 in the norm of the preconditioner
    double left = unknown;     // the square of the error
    residual = 1;
    double error_of_all = 1;  // beside the energy with penalties
    for (;;) {
      gained.start();
      const double first = along, residual_before = residual, left_before = left;
      double smallest = along;
      std::int64_t of_smallest = iterations;
      left = unknown;
      bool is_stuck = !(along > 0 && std::isfinite(along));
      for (double turn = 0; !is_stuck && iterations < max_iterations_;) {
        follow(turn, z, p);
        if (has_product) follow(turn, y, q);
        else multiply(p, q);
        const products product = products_of(p, q);
        // the matrix is not definite
        if (!(product.energy > 1e-16 * product.diagonal && std::isfinite(product.energy))) break;
        const double step = along / product.energy;
        add(step, p, x);
        add(-step, q, r);
        ++iterations;
        gained.add(step * along);
        left = gained.left();
        if (gained.is_exhausted() || (is_small(left, gained.all(), x) && largest_residual(r, b, x) <= tolerance_))
          break;
        has_product = precondition(r, z, y);
        const double before = along;
        along = dot(r, z);
        turn = along / before;
        if (along < smallest / 2) {
          smallest = along;
          of_smallest = iterations;
        }
        is_stuck = !(along > 0 && std::isfinite(along)) || iterations - of_smallest > patience_;
      }
      const double expected = along;
      subtract(x, b, y, r);
      has_product = precondition(r, z, y);
      along = dot(r, z);
      if (left == unknown) left = gained.has_any() ? gained.recent() : left_before;
      // |r|^2 is near the square of the error
      left = along == 0 ? 0 : expected == 0 ? along : left * std::max(1.0, rest_of(along, r, z) / expected);
      residual = largest_residual(r, b, x);
      error_of_all = gained.all() > 0 ? std::sqrt(left / gained.all()) : 1;
      error = gained.all() > 0 ? std::sqrt(left / energy_of_rest(gained.all(), x)) : 1;
      has_converged = error <= tolerance_ && residual <= tolerance_;
      if (has_converged || iterations >= max_iterations_ || !(along < first / 4 || residual < residual_before / 2))
        break;
    }
    has_converged |= is_limited_by_rounding(error_of_all);
  }

 private:
  /// Whether the iteration can do no better. error_of_all: beside the energy with penalties.
  bool is_limited_by_rounding(double error_of_all) const {
    return (residual <= 1e-14 && error_of_all <= 1e-6) ||
           (residual <= tolerance_ && error_of_all <= tolerance_ && iterations < max_iterations_);
  }

  /// left: the square of the error; all: x.Ax.
  bool is_small(double left, double all, const Eigen::VectorXd& x) {
    const double wanted = tolerance_ * tolerance_;
    return left <= wanted * all && left <= wanted * energy_of_rest(all, x);
  }

  /// all: x.Ax. Returns the same without penalties.
  double energy_of_rest(double all, const Eigen::VectorXd& x) {
    if (!penalties_) penalties_.emplace(a_);
    const double rest = penalties_->any() ? penalties_->energy_of_rest(x) : 0;
    return rest > 0 ? std::min(all, rest) : all;
  }

  /// along: r.z. Returns the same without penalties, whose rows have large rounding errors in r, and small ones in x.
  double rest_of(double along, const Eigen::VectorXd& r, const Eigen::VectorXd& z) {
    if (!penalties_) penalties_.emplace(a_);
    return penalties_->any() ? penalties_->product_of_rest(r, z) : along;
  }

  static double dot(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
    double sum[4] = {};  // several, so that additions are independent
    const Eigen::Index n = x.size() / 4 * 4;
    for (Eigen::Index i = 0; i < n; i += 4)
      for (Eigen::Index k = 0; k < 4; ++k) sum[k] += x[i + k] * y[i + k];
    for (Eigen::Index i = n; i < x.size(); ++i) sum[0] += x[i] * y[i];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
  }

  /// p = z + turn p; with turn = 0 what was in p does not matter.
  static void follow(double turn, const Eigen::VectorXd& z, Eigen::VectorXd& p) {
    for (Eigen::Index i = 0; i < z.size(); ++i) p[i] = turn == 0 ? z[i] : z[i] + turn * p[i];
  }

  /// x += step p.
  static void add(double step, const Eigen::VectorXd& p, Eigen::VectorXd& x) {
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] += step * p[i];
  }

  products products_of(const Eigen::VectorXd& p, const Eigen::VectorXd& q) const {
    const auto n = static_cast<Eigen::Index>(diagonal_.size());
    double energy[4] = {}, diagonal[4] = {};
    const auto add = [&](Eigen::Index i, Eigen::Index k) {
      energy[k] += p[i] * q[i];
      diagonal[k] += diagonal_[static_cast<std::size_t>(i)] * p[i] * p[i];
    };
    Eigen::Index i = 0;
    for (; i + 4 <= n; i += 4)
      for (Eigen::Index k = 0; k < 4; ++k) add(i + k, k);
    for (; i < n; ++i) add(i, 0);
    return {(energy[0] + energy[1]) + (energy[2] + energy[3]),
            (diagonal[0] + diagonal[1]) + (diagonal[2] + diagonal[3])};
  }

  /// y = A x.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
    const auto n = static_cast<int>(a_.cols());
    const int *const starts = a_.outerIndexPtr(), *const rows = a_.innerIndexPtr();
    const double* const a = a_.valuePtr();
    for (int c = 0; c < n; ++c) y[c] = 0;
    for (int c = 0; c < n; ++c) {
      const double xc = x[c];
      double sum = a[starts[c]] * xc;
      for (int k = starts[c] + 1; k < starts[c + 1]; ++k) {
        y[rows[k]] += a[k] * xc;
        sum += a[k] * x[rows[k]];
      }
      y[c] += sum;
    }
  }

  /// Whether a row has so many entries that rounding errors of its sum are far above those of one number.
  bool has_long_rows() const {
    constexpr int long_row = 1000;
    const auto n = static_cast<std::size_t>(a_.cols());
    std::vector<int> entries(n);
    for (Eigen::Index k = 0; k < a_.nonZeros(); ++k) ++entries[static_cast<std::size_t>(a_.innerIndexPtr()[k])];
    for (std::size_t c = 0; c < n; ++c)
      if (entries[c] + a_.outerIndexPtr()[c + 1] - a_.outerIndexPtr()[c] > long_row) return true;
    return false;
  }

  /// r = b - A x; y: for a product.
  void subtract(const Eigen::VectorXd& x, const Eigen::VectorXd& b, Eigen::VectorXd& y, Eigen::VectorXd& r) const {
    if (has_long_rows()) return subtract_exactly(x, b, r);
    multiply(x, y);
    for (Eigen::Index i = 0; i < r.size(); ++i) r[i] = b[i] - y[i];
  }

  /// r = b - A x, with the rounding errors of all additions added up beside.
  void subtract_exactly(const Eigen::VectorXd& x, const Eigen::VectorXd& b, Eigen::VectorXd& r) const {
    const auto n = static_cast<int>(a_.cols());
    const int *const starts = a_.outerIndexPtr(), *const rows = a_.innerIndexPtr();
    const double* const a = a_.valuePtr();
    std::vector<double> errors(static_cast<std::size_t>(n));
    const auto subtract = [&](int i, double term) {
      const double before = r[i], sum = before - term, added = sum - before;
      errors[static_cast<std::size_t>(i)] += (before - (sum - added)) - (term + added);
      r[i] = sum;
    };
    for (int i = 0; i < n; ++i) r[i] = b[i];
    for (int c = 0; c < n; ++c)
      for (int k = starts[c]; k < starts[c + 1]; ++k) {
        subtract(rows[k], a[k] * x[c]);
        if (rows[k] != c) subtract(c, a[k] * x[rows[k]]);
      }
    for (int i = 0; i < n; ++i) r[i] += errors[static_cast<std::size_t>(i)];
  }

  /// The largest |r|_i / (|b|_i + a_ii max|x|), or its value with the unknowns scaled to a diagonal of 1, if that is
  /// larger for a row.
  double largest_residual(const Eigen::VectorXd& r, const Eigen::VectorXd& b, const Eigen::VectorXd& x) const {
    double largest = 0, largest_scaled = 0, worst = 0;
    for (Eigen::Index i = 0; i < a_.cols(); ++i) {
      const double xi = x[i] * x[i];
      largest = std::max(largest, xi);
      largest_scaled = std::max(largest_scaled, diagonal_[static_cast<std::size_t>(i)] * xi);
    }
    largest = std::sqrt(largest);
    for (Eigen::Index i = 0; i < a_.cols(); ++i) {
      const double d = diagonal_[static_cast<std::size_t>(i)],
                   allowed = std::abs(b[i]) + std::min(d * largest, std::sqrt(d * largest_scaled));
      const double e = r[i] == 0 ? 0 : std::abs(r[i]) / allowed;
      if (e > worst || std::isnan(e)) worst = e;
    }
    return worst;
  }
};

}  // namespace concino::detail
