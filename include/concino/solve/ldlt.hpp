// A direct solver for symmetric sparse systems, by L D L^T factorisation.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/core/system_checks.hpp>
#include <concino/solve/detail/ordered.hpp>
#include <concino/solve/detail/sparse_factor.hpp>
#include <concino/solve/detail/supernodes.hpp>

#include <Eigen/SparseCore>

#include <cstdint>
#include <limits>

namespace concino {

/// What a factorisation costs, counted before it begins. Where ldlt is going to try nested dissection, the numbers are those that it commonly leaves.
struct factor_size {
  double entries = 0;          // of L, below the diagonal
  double multiplications = 0;  // up to the number of unknowns
};

/// Factorises a symmetric matrix as L D L^T, with a fill-reducing order, and solves with it. A SparseSolver.
/// Reads only the lower triangle of the matrix. Matrices may be indefinite, but there is no pivoting: D is diagonal.
/// A matrix with the pattern of the previously factorised one, explicit zeros included, reuses its order. The order is by minimum degree, or by nested
/// dissection of the graph where the factorisation is costly and takes fewer multiplications in this order, as on large meshes.
/// Errors: factorize throws solver_error, with the reason, if the matrix is not square, has entries that are not finite, or is singular (the message
///         names the row). solve throws it if nothing was factorised, the right-hand side has another size, or an entry of it or of the solution is
///         not finite. After a failed factorize, nothing is factorised.
/// Source: approximate minimum degree ordering, Amestoy, Davis, Duff 1996; nested dissection, George 1973; factorisation, Davis 2005 (Algorithm 849);
///         substitution by supernodes, Ng, Peyton 1993.
class ldlt {
  detail::elimination_order order_;
  detail::sparse_factor factors_;  // of the reordered matrix
  detail::supernodes supernodes_;
  core::sparsity_pattern pattern_;  // of the matrix for which the order was computed
  enum class progress { ordered, copied, counted, chosen };
  progress progress_ = progress::ordered;  // with the pattern: it is ordered by minimum degree; has the order of another solver; factors_ has analysed
                                           // it by minimum degree; factors_ has analysed it in the better order
  bool is_countable_ = true;               // 32-bit indices can count the entries of the factor by minimum degree
  Eigen::Index size_ = -1;

 public:
  ldlt();
  ldlt(const ldlt&) = delete;
  ldlt& operator=(const ldlt&) = delete;
  ~ldlt();

  static constexpr std::int64_t any_number = std::numeric_limits<std::int64_t>::max();

  void factorize(const Eigen::SparseMatrix<double>& matrix) { factorize_within(matrix, any_number); }

  /// factorize, unless the factor in the order by minimum degree would have more than `most` entries below the diagonal, or accepts(size) is false. Then the
  /// result is false, nothing is factorised, and the cost is that of this order. The order is kept if the size was counted and not accepted.
  bool factorize_within(const Eigen::SparseMatrix<double>& matrix, std::int64_t most, function_ref<bool(const factor_size&)> accepts = nullptr);

  /// Whether this matrix has the pattern of the previous one that was ordered, so that its order can be reused.
  bool has_order_of(const Eigen::SparseMatrix<double>& a) const { return a.isCompressed() && pattern_.is_of(a); }

  /// Copies the order of another solver, so that a matrix of the same pattern need not be ordered again. Afterwards nothing is factorised
  /// until the next factorize.
  void use_order_of(const ldlt& other);

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  /// Orders a and counts the entries of its factor, unless that is done for its pattern; upper: the reordered a. Returns false if there are more than `most`.
  bool count(const Eigen::SparseMatrix<double>& a, std::int64_t most, Eigen::SparseMatrix<double>& upper);

  /// Whether nested dissection may pay for the matrix, which is ordered by minimum degree; entries: of its lower triangle.
  bool may_dissect(Eigen::Index entries) const;
  factor_size expected_size(Eigen::Index entries) const;

  /// Dissects a if that may pay, and keeps the better order. upper: a in the first order, afterwards in the chosen one. Returns false if the factor would
  /// have more than `most` entries.
  bool choose_order(const Eigen::SparseMatrix<double>& a, std::int64_t most, Eigen::SparseMatrix<double>& upper);

  /// Rejects pivots that are only rounding errors. A pivot is a diagonal entry minus the contributions of elimination.
  void check_pivots(const Eigen::SparseMatrix<double>& a);
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/ldlt.ipp>
#endif
