// Factorisation as L D L^T; see ldlt.hpp.
#pragma once

#include <concino/solve/ldlt.hpp>

#include <cmath>
#include <vector>

namespace concino {

CONCINO_INLINE ldlt::ldlt() = default;
CONCINO_INLINE ldlt::~ldlt() = default;

CONCINO_INLINE bool ldlt::factorize_within(const Eigen::SparseMatrix<double>& matrix, std::int64_t most) {
  size_ = -1;
  Eigen::SparseMatrix<double> storage;
  const Eigen::SparseMatrix<double>& a = core::compressed(matrix, storage);
  core::check_square("ldlt", a);
  core::check_entries("ldlt", a);
  if (a.cols() == 0) {
    size_ = 0;
    return true;
  }
  const bool has_order = pattern_.is_of(a);
  if (has_order && is_analysed_) {
    factors_.factorize(order_(a));
  } else {
    is_analysed_ = false;
    if (!has_order) {
      pattern_.forget();
      order_.find(a);
    }
    const Eigen::SparseMatrix<double> upper = order_(a);
    if (const std::int64_t n = a.cols(); n * (n - 1) / 2 > most && detail::factor_entries(upper, most) > most) return false;
    factors_.compute(upper);
    is_analysed_ = true;
    if (!has_order) pattern_.remember(a);
  }
  check_pivots(a);
  supernodes_.find(factors_.matrixL().nestedExpression());
  size_ = a.rows();
  return true;
}

CONCINO_INLINE void ldlt::use_order_of(const ldlt& other) {
  size_ = -1;
  is_analysed_ = false;
  if (this == &other) return;
  pattern_.forget();  // in case that there is no memory for the order
  order_ = detail::elimination_order(other.order_);
  pattern_ = other.pattern_;
}

CONCINO_INLINE Eigen::VectorXd ldlt::solve(const Eigen::VectorXd& b) const {
  core::check_right_hand_side("ldlt", b, size_);
  if (size_ == 0) return Eigen::VectorXd(0);
  Eigen::VectorXd x = order_.place * b;
  const Eigen::SparseMatrix<double>& l = factors_.matrixL().nestedExpression();
  supernodes_.solve_lower(l, x);
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] /= pivots_[i];
  supernodes_.solve_upper(l, x);
  x = order_.row * x;
  core::check_solution("ldlt", x);
  return x;
}

CONCINO_INLINE void ldlt::check_pivots(const Eigen::SparseMatrix<double>& a) {
  const std::vector<double> given = core::diagonal(a);
  pivots_ = factors_.vectorD();
  const auto& row = order_.row.indices();
  for (Eigen::Index k = 0; k < pivots_.size(); ++k) {  // elimination stops at the first 0
    const double diagonal = given[static_cast<std::size_t>(row[k])];
    if (!(std::abs(pivots_[k]) > 1e-15 * std::abs(diagonal) && std::abs(pivots_[k]) < std::numeric_limits<double>::infinity()))
      core::throw_bad_pivot("ldlt", "singular to working precision", row[k], diagonal, pivots_[k]);
  }
}

}  // namespace concino
