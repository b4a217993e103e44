// Factorisation as L D L^T; see ldlt.hpp.
#pragma once

#include <concino/solve/detail/direct/ordered_factors.hpp>
#include <concino/solve/ldlt.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace concino {

struct ldlt::state : detail::ordered_factors<detail::simplicial_ldlt> {
  explicit state(const direct_solver_options& given) : ordered_factors("ldlt", given) {}

  /// Rejects pivots that are only rounding errors. A pivot is a diagonal entry minus the contributions of elimination,
  /// which stops at the first 0.
  void check_pivots(const Eigen::SparseMatrix<double>& a) const {
    const std::vector<double> input_diagonal = core::diagonal(a);
    const Eigen::VectorXd pivots = factors.vectorD();
    for (std::size_t k = 0; k < input_diagonal.size(); ++k) {
      const int row = order.row[k];
      const double diagonal = input_diagonal[static_cast<std::size_t>(row)],
                   pivot = pivots[static_cast<Eigen::Index>(k)];
      if (!(std::abs(pivot) > 1e-15 * std::abs(diagonal) && std::abs(pivot) < std::numeric_limits<double>::infinity()))
        core::throw_bad_pivot("ldlt", "singular to working precision", row, diagonal, pivot);
    }
  }
};

CONCINO_INLINE ldlt::ldlt(const direct_solver_options& options) : state_(new state(options)) {}
CONCINO_INLINE ldlt::~ldlt() = default;

CONCINO_INLINE void ldlt::factorize(const Eigen::SparseMatrix<double>& matrix) {
  if (!factorize_within(matrix, std::numeric_limits<std::int64_t>::max())) state_->throw_too_large();
}

CONCINO_INLINE bool ldlt::factorize_within(const Eigen::SparseMatrix<double>& matrix, std::int64_t most) {
  return state_->factorize(matrix, most, [&](const auto& a, const auto&) { state_->check_pivots(a); });
}

CONCINO_INLINE void ldlt::use_order_of(const ldlt& other) { state_->use_order_of(*other.state_); }

CONCINO_INLINE Eigen::VectorXd ldlt::solve(const Eigen::VectorXd& b) const { return state_->solve(b); }

CONCINO_INLINE const direct_solver_options& ldlt::options() const { return state_->options; }

}  // namespace concino
