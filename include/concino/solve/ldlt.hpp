// Symmetric sparse systems by factorisation.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/system_checks.hpp>
#include <concino/solve/detail/ordered.hpp>
#include <concino/solve/detail/sparse_factor.hpp>
#include <concino/solve/detail/supernodes.hpp>

#include <Eigen/SparseCore>

#include <cstdint>
#include <limits>

namespace concino {

/// Factorises a symmetric matrix as L D L^T, fill-reducing, and solves with it. A SparseSolver.
/// Only the lower triangle of the matrix is read. Matrices may be indefinite, but pivots are not exchanged for that: D is diagonal.
/// A matrix with the pattern of the one factorised before, explicit zeros included, is factorised in the order found then.
/// Errors: factorize throws solver_error, with the reason, if the matrix is not square, has entries that are not finite, or is singular (the row
///         is named). solve throws it if nothing was factorised, the right-hand side has another size, or an entry of it or of the solution is
///         not finite. A failed factorize leaves nothing to solve with.
/// Source: approximate minimum degree ordering, Amestoy, Davis, Duff 1996; factorisation, Davis 2005 (Algorithm 849); substitution by supernodes, Ng,
///         Peyton 1993.
class ldlt {
  detail::elimination_order order_;
  detail::sparse_factor factors_;  // of the reordered matrix
  detail::supernodes supernodes_;
  core::sparsity_pattern pattern_;  // that the order was found for
  bool is_analysed_ = false;          // factors_ knows the pattern too
  Eigen::Index size_ = -1;

 public:
  ldlt();
  ldlt(const ldlt&) = delete;
  ldlt& operator=(const ldlt&) = delete;
  ~ldlt();

  static constexpr std::int64_t any_number = std::numeric_limits<std::int64_t>::max();

  void factorize(const Eigen::SparseMatrix<double>& matrix) { factorize_within(matrix, any_number); }

  /// factorize, unless the factor would have more than `most` entries below the diagonal: then the result is false, nothing is factorised,
  /// and the cost was that of ordering.
  bool factorize_within(const Eigen::SparseMatrix<double>& matrix, std::int64_t most);

  /// Takes over the order that another has found, so that a matrix of the pattern it was found for need not be ordered again. There is nothing to solve
  /// with until the next factorize.
  void use_order_of(const ldlt& other);

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  /// A pivot is a diagonal entry minus what elimination takes away: where nothing but rounding errors is left, it says nothing.
  void check_pivots(const Eigen::SparseMatrix<double>& a);
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/ldlt.ipp>
#endif
