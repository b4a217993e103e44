// Factorisation as L L^T; see llt.hpp.
#pragma once

#include <concino/solve/detail/direct/ordered_factors.hpp>
#include <concino/solve/llt.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino {

struct llt::state : detail::ordered_factors<detail::simplicial_llt> {
  explicit state(const direct_solver_options& given) : ordered_factors("llt", given) {}

  void check_pivots(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& upper) const {
    const std::vector<double> input_diagonal = core::diagonal(a);
    const auto check = [&](Eigen::Index k, double pivot) {
      const int row = order.row[static_cast<std::size_t>(k)];
      const double diagonal = input_diagonal[static_cast<std::size_t>(row)];
      if (!(pivot > 1e-15 * diagonal && pivot > 0 && pivot < std::numeric_limits<double>::infinity()))
        core::throw_bad_pivot("llt", pivot < 0 ? "not positive definite" : "not positive definite to working precision",
                              row, diagonal, pivot);
    };
    if (factors.info() == Eigen::Success) {
      const auto& l = factors.matrixL().nestedExpression();  // each column begins with its diagonal
      for (Eigen::Index k = 0; k < l.cols(); ++k) {
        const double root = l.valuePtr()[l.outerIndexPtr()[k]];
        check(k, root * root);
      }
      return;
    }
    // Eigen does not report the row at which it stopped; LDL^T in the same order has the same pivot
    const detail::simplicial_ldlt again(upper);
    const Eigen::VectorXd pivots = again.vectorD();
    for (Eigen::Index k = 0; k < pivots.size(); ++k) check(k, pivots[k]);
    throw solver_error("llt: the matrix is not positive definite");
  }
};

CONCINO_INLINE llt::llt(const direct_solver_options& options) : state_(new state(options)) {}
CONCINO_INLINE llt::~llt() = default;

CONCINO_INLINE void llt::factorize(const Eigen::SparseMatrix<double>& matrix) {
  const auto check = [&](const auto& a, const auto& upper) { state_->check_pivots(a, upper); };
  if (!state_->factorize(matrix, std::numeric_limits<std::int64_t>::max(), check)) state_->throw_too_large();
}

CONCINO_INLINE void llt::use_order_of(const llt& other) { state_->use_order_of(*other.state_); }

CONCINO_INLINE Eigen::VectorXd llt::solve(const Eigen::VectorXd& b) const { return state_->solve(b); }

CONCINO_INLINE const direct_solver_options& llt::options() const { return state_->options; }

}  // namespace concino
