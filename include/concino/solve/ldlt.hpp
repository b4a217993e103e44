// Symmetric sparse systems by factorisation.
#pragma once

#include <concino/core/system_checks.hpp>
#include <concino/solve/detail/ordered.hpp>
#include <concino/solve/detail/supernodes.hpp>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino {

/// Factorises a symmetric matrix as L D L^T, fill-reducing, and solves with it. A SparseSolver.
/// Only the lower triangle of the matrix is read. Matrices may be indefinite, but pivots are not exchanged for that: D is diagonal.
/// A matrix with the pattern of the one factorised before, explicit zeros included, is factorised in the order found then.
/// Errors: solver_error, with the reason, from factorize if the matrix is not square, has entries that are not finite, or is singular (the row
///         is named); from solve if nothing was factorised, or the right-hand side has another size or is not finite, or the solution is not.
///         A failed factorize leaves nothing to solve with.
/// Source: Eigen's SimplicialLDLT with approximate minimum degree ordering (Amestoy, Davis, Duff 1996); substitution by supernodes, Ng, Peyton 1993.
class ldlt {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>> factors_;  // of the reordered matrix
  detail::elimination_order order_;
  detail::supernodes supernodes_;
  Eigen::VectorXd pivots_;
  core::sparsity_pattern pattern_;  // that the order was found for
  bool is_analysed_ = false;          // factors_ knows the pattern too
  Eigen::Index size_ = -1;

 public:
  static constexpr std::int64_t any_number = std::numeric_limits<std::int64_t>::max();

  void factorize(const Eigen::SparseMatrix<double>& matrix) { factorize_within(matrix, any_number); }

  /// factorize, unless the factor would have more than `most` entries below the diagonal: then the result is false, nothing is factorised,
  /// and the cost was that of ordering.
  bool factorize_within(const Eigen::SparseMatrix<double>& matrix, std::int64_t most) {
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

  /// Takes over the order that another has found, so that a matrix of the pattern it was found for need not be ordered again. There is nothing to solve
  /// with until the next factorize.
  void use_order_of(const ldlt& other) {
    size_ = -1;
    is_analysed_ = false;
    if (this == &other) return;
    pattern_.forget();  // in case that there is no memory for the order
    order_ = detail::elimination_order(other.order_);
    pattern_ = other.pattern_;
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
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

 private:
  /// A pivot is a diagonal entry minus what elimination takes away: where nothing but rounding errors is left, it says nothing.
  void check_pivots(const Eigen::SparseMatrix<double>& a) {
    const std::vector<double> given = core::diagonal(a);
    pivots_ = factors_.vectorD();
    const auto& row = order_.row.indices();
    for (Eigen::Index k = 0; k < pivots_.size(); ++k) {  // elimination stops at the first 0
      const double diagonal = given[static_cast<std::size_t>(row[k])];
      if (!(std::abs(pivots_[k]) > 1e-15 * std::abs(diagonal) && std::abs(pivots_[k]) < std::numeric_limits<double>::infinity()))
        core::throw_bad_pivot("ldlt", "singular to working precision", row[k], diagonal, pivots_[k]);
    }
  }
};

}  // namespace concino
