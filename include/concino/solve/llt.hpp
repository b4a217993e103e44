// A direct solver for symmetric positive definite sparse systems, by Cholesky factorisation.
#pragma once

#include <concino/core/system_checks.hpp>

#include <Eigen/SparseCholesky>

#include <limits>
#include <vector>

namespace concino {

/// Factorises a symmetric positive definite matrix as L L^T, with a fill-reducing order, and solves with it. A SparseSolver; use it if an indefinite
/// matrix should be an error.
/// Reads only the lower triangle of the matrix. A matrix with the pattern of the previously factorised one, explicit zeros included,
/// reuses its order.
/// Errors: factorize throws solver_error, with the reason, if the matrix is not square, has entries that are not finite, or is not positive definite
///         (the message names the row). solve throws it if nothing was factorised, the right-hand side has another size, or an entry of it or of the
///         solution is not finite. After a failed factorize, nothing is factorised.
/// Source: Eigen's SimplicialLLT with approximate minimum degree ordering (Amestoy, Davis, Duff 1996).
class llt {
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factors_;
  core::sparsity_pattern pattern_;
  Eigen::Index size_ = -1;

 public:
  void factorize(const Eigen::SparseMatrix<double>& matrix) {
    size_ = -1;
    Eigen::SparseMatrix<double> storage;
    const Eigen::SparseMatrix<double>& a = core::compressed(matrix, storage);
    core::check_square("llt", a);
    core::check_entries("llt", a);
    if (a.cols() > 0) {
      if (pattern_.is_of(a)) {
        factors_.factorize(a);
      } else {
        pattern_.forget();
        factors_.compute(a);
        pattern_.remember(a);
      }
      check_pivots(a);
    }
    size_ = a.rows();
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    core::check_right_hand_side("llt", b, size_);
    if (size_ == 0) return Eigen::VectorXd(0);
    Eigen::VectorXd x = factors_.solve(b);
    core::check_solution("llt", x);
    return x;
  }

 private:
  void check_pivots(const Eigen::SparseMatrix<double>& a) const {
    const std::vector<double> input_diagonal = core::diagonal(a);
    const auto check = [&](Eigen::Index row, double pivot) {
      const double diagonal = input_diagonal[static_cast<std::size_t>(row)];
      if (!(pivot > 1e-15 * diagonal && pivot > 0 && pivot < std::numeric_limits<double>::infinity()))
        core::throw_bad_pivot("llt", pivot < 0 ? "not positive definite" : "not positive definite to working precision", row, diagonal, pivot);
    };
    const auto& row = factors_.permutationPinv().indices();
    if (factors_.info() == Eigen::Success) {
      const auto& l = factors_.matrixL().nestedExpression();  // each column begins with its diagonal
      for (Eigen::Index k = 0; k < l.cols(); ++k) {
        const double root = l.valuePtr()[l.outerIndexPtr()[k]];
        check(row[k], root * root);
      }
      return;
    }
    // Eigen does not report the row at which it stopped; LDL^T in the same order has the same pivot
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> again(a);
    const Eigen::VectorXd pivots = again.vectorD();
    for (Eigen::Index k = 0; k < pivots.size(); ++k) check(again.permutationPinv().indices()[k], pivots[k]);
    core::throw_joined<solver_error>({"llt: the matrix is not positive definite"});
  }
};

}  // namespace concino
