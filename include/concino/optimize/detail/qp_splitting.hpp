// The parts of the operator splitting for quadratic programs: scaling, the linear system of each step, the steps, and
// the certificates.
#pragma once

#include <concino/core/error.hpp>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace concino::detail {

using sparse_matrix = Eigen::SparseMatrix<double>;

inline double largest(const Eigen::VectorXd& x) {
  double most = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i)
    if (!(std::abs(x[i]) <= most)) most = std::abs(x[i]);
  return most;
}

/// minimise x.Hx/2 + g.x subject to low <= Ax <= high, with rows, columns and the objective scaled so that entries are
/// about 1.
struct scaled_qp {
  sparse_matrix h, a;  // h: both triangles
  Eigen::VectorXd g, low, high;
  Eigen::VectorXd column, row;  // x = column * (scaled x), (scaled A x) = row * (A x)
  double objective = 1;

  /// Source: Ruiz 2001, "A scaling algorithm to equilibrate both rows and columns norms in matrices", as in OSQP.
  scaled_qp(const sparse_matrix& h_, const Eigen::VectorXd& g_, const sparse_matrix& a_, const Eigen::VectorXd& low_,
            const Eigen::VectorXd& high_)
      : h(h_), a(a_), g(g_), low(low_), high(high_), column(Eigen::VectorXd::Ones(g_.size())),
        row(Eigen::VectorXd::Ones(low_.size())) {
    for (int round = 0; round < 10; ++round) {
      Eigen::VectorXd of_column = Eigen::VectorXd::Zero(g.size()), of_row = Eigen::VectorXd::Zero(low.size());
      each(h, [&](Eigen::Index, Eigen::Index c, double& x) { of_column[c] = std::max(of_column[c], std::abs(x)); });
      each(a, [&](Eigen::Index r, Eigen::Index c, double& x) {
        of_column[c] = std::max(of_column[c], std::abs(x));
        of_row[r] = std::max(of_row[r], std::abs(x));
      });
      for (Eigen::VectorXd* v : {&of_column, &of_row})
        for (Eigen::Index i = 0; i < v->size(); ++i) (*v)[i] = (*v)[i] > 0 ? 1 / std::sqrt((*v)[i]) : 1;
      each(h, [&](Eigen::Index r, Eigen::Index c, double& x) { x *= of_column[r] * of_column[c]; });
      each(a, [&](Eigen::Index r, Eigen::Index c, double& x) { x *= of_row[r] * of_column[c]; });
      g = g.cwiseProduct(of_column);
      column = column.cwiseProduct(of_column);
      row = row.cwiseProduct(of_row);
    }
    double most = largest(g);
    each(h, [&](Eigen::Index, Eigen::Index, double& x) { most = std::max(most, std::abs(x)); });
    if (most > 0) objective = 1 / most;
    each(h, [&](Eigen::Index, Eigen::Index, double& x) { x *= objective; });
    g *= objective;
    low = low.cwiseProduct(row);
    high = high.cwiseProduct(row);
  }

  template<class F>
  static void each(sparse_matrix& m, F&& f) {
    for (int c = 0; c < m.outerSize(); ++c)
      for (sparse_matrix::InnerIterator it(m, c); it; ++it) f(it.row(), static_cast<Eigen::Index>(c), it.valueRef());
  }
};

/// The quasi-definite matrix (H + shift, A^T; A, -1 / weight), lower triangle. Its factorisation needs no pivoting.
/// Source: Vanderbei 1995, "Symmetric quasidefinite matrices".
class quasidefinite {
  Eigen::SimplicialLDLT<sparse_matrix> factors_;
  Eigen::Index size_ = 0;

 public:
  /// Errors: solver_error if H + shift is not positive definite.
  void factorize(const sparse_matrix& h, double shift, const sparse_matrix& a, const Eigen::VectorXd& inverse_weight) {
    const Eigen::Index n = h.cols();
    size_ = n + a.rows();
    if (size_ == 0) return;
    std::vector<Eigen::Triplet<double>> t;
    t.reserve(static_cast<std::size_t>(h.nonZeros() + a.nonZeros() + size_));
    for (int c = 0; c < h.outerSize(); ++c)
      for (sparse_matrix::InnerIterator it(h, c); it; ++it)
        if (it.row() >= c) t.emplace_back(static_cast<int>(it.row()), c, it.value());
    for (int c = 0; c < a.outerSize(); ++c)
      for (sparse_matrix::InnerIterator it(a, c); it; ++it)
        t.emplace_back(static_cast<int>(n + it.row()), c, it.value());
    for (int i = 0; i < n; ++i) t.emplace_back(i, i, shift);
    for (Eigen::Index i = 0; i < a.rows(); ++i)
      t.emplace_back(static_cast<int>(n + i), static_cast<int>(n + i), -inverse_weight[i]);
    sparse_matrix k(size_, size_);
    k.setFromTriplets(t.begin(), t.end());
    factors_.compute(k);
    Eigen::Index negative = 0;
    if (factors_.info() == Eigen::Success) {
      const Eigen::VectorXd pivots = factors_.vectorD();
      for (Eigen::Index i = 0; i < size_; ++i) negative += pivots[i] < 0;
    }
    if (factors_.info() != Eigen::Success || negative != a.rows())
      throw solver_error("quadratic program: H is not positive semidefinite, so the objective is not convex");
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return size_ == 0 ? b : Eigen::VectorXd(factors_.solve(b)); }
};

/// The iterates of the operator splitting, in the scaled program: x, multipliers y, and the values z of the rows,
/// within their bounds.
class splitting_iterates {
  static constexpr double shift = 1e-6, relaxation = 1.6;
  const scaled_qp& p_;
  double rho_ = 0.1;
  Eigen::VectorXd weight_;  // of the rows
  quasidefinite system_;
  Eigen::VectorXd x_, y_, z_, x_before_, y_before_, b_;

  void factorize() {
    for (Eigen::Index i = 0; i < weight_.size(); ++i)
      weight_[i] = p_.low[i] == p_.high[i] ? 1e3 * rho_ : std::isinf(p_.low[i]) && std::isinf(p_.high[i]) ? 1e-6 : rho_;
    system_.factorize(p_.h, shift, p_.a, weight_.cwiseInverse());
  }

 public:
  /// Starts at x and multipliers of the unscaled program.   Errors: solver_error if H + shift is not positive definite.
  splitting_iterates(const scaled_qp& p, const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers)
      : p_(p), weight_(p.low.size()), b_(p.g.size() + p.low.size()) {
    factorize();
    x_ = x.cwiseQuotient(p.column);
    y_ = p.objective * multipliers.cwiseQuotient(p.row);
    z_ = p.a * x_;
    for (Eigen::Index i = 0; i < z_.size(); ++i) z_[i] = std::clamp(z_[i], p.low[i], p.high[i]);
  }

  void step() {
    const Eigen::Index n = x_.size(), m = z_.size();
    x_before_ = x_;
    y_before_ = y_;
    b_.head(n) = shift * x_ - p_.g;
    b_.tail(m) = z_ - y_.cwiseQuotient(weight_);
    const Eigen::VectorXd s = system_.solve(b_);
    x_ = relaxation * s.head(n) + (1 - relaxation) * x_;
    for (Eigen::Index i = 0; i < m; ++i) {
      const double z_tilde = relaxation * (z_[i] + (s[n + i] - y_[i]) / weight_[i]) + (1 - relaxation) * z_[i];
      const double next = std::clamp(z_tilde + y_[i] / weight_[i], p_.low[i], p_.high[i]);
      y_[i] += weight_[i] * (z_tilde - next);
      z_[i] = next;
    }
  }

  /// Adapts the weights so that both residuals decrease equally. `ratio` is the primal residual over the dual one, each
  /// relative to its terms.
  void balance(double ratio) {
    if (!(ratio > 5 || ratio < 0.2)) return;  // the residuals are balanced
    const double better = std::clamp(rho_ * ratio, 1e-6, 1e6);
    if (better == rho_) return;
    rho_ = better;
    factorize();
  }

  // of the unscaled program
  Eigen::VectorXd x() const { return x_.cwiseProduct(p_.column); }
  Eigen::VectorXd multipliers() const { return y_.cwiseProduct(p_.row) / p_.objective; }
  Eigen::VectorXd row_values() const { return z_.cwiseQuotient(p_.row); }

  // changes in the last step, scaled
  Eigen::VectorXd x_change() const { return x_ - x_before_; }
  Eigen::VectorXd multiplier_change() const { return y_ - y_before_; }
};

/// Whether dy proves that no x satisfies low <= Ax <= high: A^T dy = 0 and the bounds selected by dy contradict each
/// other.
inline bool proves_infeasible(const scaled_qp& p, const Eigen::VectorXd& dy, double tolerance) {
  const double size = largest(dy);
  if (!(size > 0) || !std::isfinite(size)) return false;
  double support = 0;
  for (Eigen::Index i = 0; i < dy.size(); ++i) {
    const double y = std::abs(dy[i]) <= tolerance * size ? 0 : dy[i];
    if (y == 0) continue;
    const double bound = y > 0 ? p.high[i] : p.low[i];
    if (std::isinf(bound)) return false;
    support += bound * y;
  }
  return support < -tolerance * size && largest(p.a.transpose() * dy) <= tolerance * size;
}

/// Whether the objective decreases without bound along dx.
inline bool proves_unbounded(const scaled_qp& p, const Eigen::VectorXd& dx, double tolerance) {
  const double size = largest(dx);
  if (!(size > 0) || !std::isfinite(size) || !(p.g.dot(dx) < -tolerance * size)) return false;
  if (largest(p.h * dx) > tolerance * size) return false;
  const Eigen::VectorXd along = p.a * dx;
  for (Eigen::Index i = 0; i < along.size(); ++i) {
    if (!std::isinf(p.high[i]) && along[i] > tolerance * size) return false;
    if (!std::isinf(p.low[i]) && along[i] < -tolerance * size) return false;
  }
  return true;
}

}  // namespace concino::detail
