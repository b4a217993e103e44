// Factorisation as L D L^T; see ldlt.hpp.
#pragma once

#include <concino/solve/detail/nested_dissection.hpp>
#include <concino/solve/ldlt.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace concino {

CONCINO_INLINE ldlt::ldlt() = default;
CONCINO_INLINE ldlt::~ldlt() = default;

CONCINO_INLINE bool ldlt::factorize_within(const Eigen::SparseMatrix<double>& matrix, std::int64_t most, function_ref<bool(const factor_size&)> accepts) {
  size_ = -1;
  Eigen::SparseMatrix<double> storage;
  const Eigen::SparseMatrix<double>& a = core::compressed(matrix, storage);
  core::check_square("ldlt", a);
  core::check_entries("ldlt", a);
  if (a.cols() == 0) {
    size_ = 0;
    return true;
  }
  Eigen::SparseMatrix<double> upper;
  bool fits = count(a, most, upper);
  if (fits && accepts && !accepts(expected_size(upper.nonZeros()))) return false;
  fits = fits && choose_order(a, most, upper);
  if (!fits && most != any_number) return false;
  if (!fits) throw unsupported("ldlt: the factor would have more entries than 32-bit indices can count; use multigrid");
  factors_.factorize(upper);
  check_pivots(a);
  supernodes_.find(factors_.lower());
  size_ = a.rows();
  return true;
}

CONCINO_INLINE bool ldlt::count(const Eigen::SparseMatrix<double>& a, std::int64_t most, Eigen::SparseMatrix<double>& upper) {
  const bool has_order = pattern_.is_of(a);
  if (!has_order) {
    pattern_.forget();
    order_.find(a);
    progress_ = progress::ordered;
  }
  order_(a).swap(upper);
  if (progress_ == progress::counted || progress_ == progress::chosen) return factors_.lower().nonZeros() <= most;
  is_countable_ = factors_.analyse(upper, most);
  if (!is_countable_ && (progress_ == progress::copied || most != any_number)) return false;
  progress_ = progress_ == progress::copied ? progress::chosen : progress::counted;
  if (!has_order) pattern_.remember(a);
  return true;
}

CONCINO_INLINE bool ldlt::may_dissect(Eigen::Index entries) const {
  if (progress_ == progress::chosen) return false;
  if (!is_countable_) return true;
  // Dissection takes about as long as 50 multiplications per entry and level of cuts, and saves a third or more of them all on large meshes.
  const double num_levels = std::log2(1 + static_cast<double>(order_.row.size()) / 200);
  return static_cast<double>(factors_.num_multiplications()) >= 250 * static_cast<double>(entries) * num_levels;
}

CONCINO_INLINE factor_size ldlt::expected_size(Eigen::Index entries) const {
  factor_size r{static_cast<double>(factors_.lower().nonZeros()), static_cast<double>(factors_.num_multiplications())};
  return may_dissect(entries) ? factor_size{0.7 * r.entries, 0.45 * r.multiplications} : r;
}

CONCINO_INLINE bool ldlt::choose_order(const Eigen::SparseMatrix<double>& a, std::int64_t most, Eigen::SparseMatrix<double>& upper) {
  if (may_dissect(upper.nonZeros())) {
    const std::int64_t multiplications = is_countable_ ? factors_.num_multiplications() : any_number;
    progress_ = progress::ordered;
    factors_ = {};  // its memory is not needed meanwhile
    detail::elimination_order dissected;
    dissected.keep(detail::nested_dissection_order(detail::elimination_order::symmetric_pattern(a), order_.row));
    Eigen::SparseMatrix<double> reordered;
    if (!dissected.row.empty()) dissected(a).swap(reordered);
    if (!dissected.row.empty() && factors_.analyse(reordered, most) && factors_.num_multiplications() < multiplications) {
      std::swap(order_, dissected);
      upper.swap(reordered);
    } else if (!factors_.analyse(upper, most)) {
      return false;
    }
  }
  progress_ = progress::chosen;
  return true;
}

CONCINO_INLINE void ldlt::use_order_of(const ldlt& other) {
  size_ = -1;
  if (this == &other) return;
  pattern_.forget();  // in case that memory for the order runs out
  order_ = detail::elimination_order(other.order_);
  pattern_ = other.pattern_;
  progress_ = progress::copied;
}

CONCINO_INLINE Eigen::VectorXd ldlt::solve(const Eigen::VectorXd& b) const {
  core::check_right_hand_side("ldlt", b, size_);
  if (size_ == 0) return Eigen::VectorXd(0);
  const double* const pivot = factors_.pivots().data();
  const int* const row = order_.row.data();
  Eigen::VectorXd x(size_), y(size_);
  for (Eigen::Index i = 0; i < size_; ++i) y[i] = b[row[i]];
  supernodes_.solve_lower(factors_.lower(), y);
  for (Eigen::Index i = 0; i < size_; ++i) y[i] /= pivot[i];
  supernodes_.solve_upper(factors_.lower(), y);
  for (Eigen::Index i = 0; i < size_; ++i) x[row[i]] = y[i];
  core::check_solution("ldlt", x);
  return x;
}

CONCINO_INLINE void ldlt::check_pivots(const Eigen::SparseMatrix<double>& a) {
  const std::vector<double> input_diagonal = core::diagonal(a);
  const double* const pivots = factors_.pivots().data();
  for (std::size_t k = 0; k < input_diagonal.size(); ++k) {  // elimination stops at the first 0
    const int row = order_.row[k];
    const double diagonal = input_diagonal[static_cast<std::size_t>(row)];
    if (!(std::abs(pivots[k]) > 1e-15 * std::abs(diagonal) && std::abs(pivots[k]) < std::numeric_limits<double>::infinity()))
      core::throw_bad_pivot("ldlt", "singular to working precision", row, diagonal, pivots[k]);
  }
}

}  // namespace concino
