// A direct solver for symmetric sparse systems, by L D L^T factorisation.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/system_checks.hpp>
#include <concino/solve/direct_solver_options.hpp>

#include <Eigen/SparseCore>

#include <cstdint>
#include <memory>

namespace concino {

/// Factorises a symmetric matrix as L D L^T, with a fill-reducing order, and solves with it. A SparseSolver.
/// Reads only the lower triangle of the matrix. Matrices may be indefinite, but there is no pivoting: D is diagonal.
/// The order is by minimum degree, or by options.ordering: ldlt solver({.ordering = metis}) takes half of the time on
/// large volumes. A matrix with the pattern of the previously factorised one, explicit zeros included, reuses its
/// order. Above some 50,000 unknowns multigrid answers single questions sooner, and cholmod factorises in a third of
/// the time or less.
/// Errors: factorize throws solver_error, with the reason, if the matrix is not square, has entries that are not
///         finite, or is singular (the message names the row). It throws unsupported if 32-bit indices cannot count the
///         entries of the factor, and invalid_argument if options.ordering returns no permutation. solve throws
///         solver_error if nothing was factorised, the right-hand side has another size, or an entry of it or of the
///         solution is not finite. After a failed factorize, nothing is factorised.
/// Source: Eigen's SimplicialLDLT with approximate minimum degree ordering (Amestoy, Davis, Duff 1996).
class ldlt {
  struct state;  // Eigen's factors, which take long to compile
  std::unique_ptr<state> state_;

 public:
  explicit ldlt(const direct_solver_options& options);
  ldlt() : ldlt(direct_solver_options()) {}
  ldlt(const ldlt&) = delete;
  ldlt& operator=(const ldlt&) = delete;
  ~ldlt();

  void factorize(const Eigen::SparseMatrix<double>& matrix);

  /// factorize, unless the factor would have more than `most` entries below the diagonal, or more than 32-bit indices
  /// can count. Then the result is false, nothing is factorised, and no memory was taken for the factor. The order is
  /// kept.
  bool factorize_within(const Eigen::SparseMatrix<double>& matrix, std::int64_t most);

  /// Copies the order of another solver, so that a matrix of the same pattern need not be ordered again. Afterwards
  /// nothing is factorised until the next factorize.
  void use_order_of(const ldlt& other);

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  const direct_solver_options& options() const;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/direct/ldlt.ipp>
#endif
