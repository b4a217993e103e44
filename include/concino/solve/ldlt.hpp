// A direct solver for symmetric sparse systems, by L D L^T factorisation.
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
  bool is_analysed_ = false;          // factors_ has analysed the pattern too
  Eigen::Index size_ = -1;

 public:
  ldlt();
  ldlt(const ldlt&) = delete;
  ldlt& operator=(const ldlt&) = delete;
  ~ldlt();

  static constexpr std::int64_t any_number = std::numeric_limits<std::int64_t>::max();

  void factorize(const Eigen::SparseMatrix<double>& matrix) { factorize_within(matrix, any_number); }

  /// factorize, unless the factor in the order by minimum degree would have more than `most` entries below the diagonal. Then the result is false, nothing
  /// is factorised, and the cost is that of this order.
  bool factorize_within(const Eigen::SparseMatrix<double>& matrix, std::int64_t most);

  /// Copies the order of another solver, so that a matrix of the same pattern need not be ordered again. Afterwards nothing is factorised
  /// until the next factorize.
  void use_order_of(const ldlt& other);

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  /// Analyses the factor of a in the order by minimum degree, or in a better one. upper: a in the first order, afterwards in the chosen one. Returns false if
  /// the factor would have too many entries.
  bool choose_order(const Eigen::SparseMatrix<double>& a, std::int64_t most, Eigen::SparseMatrix<double>& upper);

  /// Rejects pivots that are only rounding errors. A pivot is a diagonal entry minus the contributions of elimination.
  void check_pivots(const Eigen::SparseMatrix<double>& a);
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/ldlt.ipp>
#endif
