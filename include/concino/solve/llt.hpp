// A direct solver for symmetric positive definite sparse systems, by Cholesky factorisation.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/system_checks.hpp>
#include <concino/solve/direct_solver_options.hpp>

#include <Eigen/SparseCore>

#include <memory>

namespace concino {

/// Factorises a symmetric positive definite matrix as L L^T, with a fill-reducing order, and solves with it. A
/// SparseSolver; use it if an indefinite matrix should be an error.
/// Reads only the lower triangle of the matrix. The order is by minimum degree, or by options.ordering. A matrix with
/// the pattern of the previously factorised one, explicit zeros included, reuses its order.
/// Errors: factorize throws solver_error, with the reason, if the matrix is not square, has entries that are not
///         finite, or is not positive definite (the message names the row). It throws unsupported if 32-bit indices
///         cannot count the entries of the factor, and invalid_argument if options.ordering returns no permutation.
///         solve throws solver_error if nothing was factorised, the right-hand side has another size, or an entry of it
///         or of the solution is not finite. After a failed factorize, nothing is factorised.
/// Source: Eigen's SimplicialLLT with approximate minimum degree ordering (Amestoy, Davis, Duff 1996).
class llt {
  struct state;  // Eigen's factors, which take long to compile
  std::unique_ptr<state> state_;

 public:
  explicit llt(const direct_solver_options& options);
  llt() : llt(direct_solver_options()) {}
  llt(const llt&) = delete;
  llt& operator=(const llt&) = delete;
  ~llt();

  void factorize(const Eigen::SparseMatrix<double>& matrix);

  /// Copies the order of another solver, see ldlt.
  void use_order_of(const llt& other);

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  const direct_solver_options& options() const;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/direct/llt.ipp>
#endif
