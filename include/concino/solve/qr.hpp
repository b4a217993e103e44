// A direct solver for least-squares problems and square systems, by QR factorisation.
#pragma once

#include <concino/core/equilibrate.hpp>
#include <concino/solve/checked_solver.hpp>

#include <Eigen/SparseQR>

#include <vector>

namespace concino {

/// Factorises a matrix of at least as many rows as columns as Q R with column exchanges, and computes the x that
/// minimises |a x - b|: the solution if there is one. A SparseSolver. It loses no digits to normal equations, but R
/// fills in: for some thousand unknowns at most. Reads the whole matrix, also both triangles of a symmetric one.
/// Columns are scaled by powers of two first, so that units of unknowns do not matter. A matrix with the pattern of the
/// previously factorised one reuses its order.
/// Errors: factorize throws solver_error, with the reason, if the matrix has fewer rows than columns, entries that are
///         not finite, or columns that depend on others to working precision (the message names one). solve throws it
///         if nothing was factorised, the right-hand side has another size, or an entry of it or of the solution is not
///         finite. After a failed factorize, nothing is factorised.
/// Source: Eigen's SparseQR, with column approximate minimum degree ordering (Davis et al. 2004).
class qr {
  Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> factors_;
  checked_solver checks_{"qr"};
  std::vector<double> column_scale_;
  std::vector<int> kept_;  // rows with entries; Eigen accepts no others

 public:
  static constexpr bool reads_both_triangles = true;
  static constexpr bool solves_least_squares = true;

  void factorize(const Eigen::SparseMatrix<double>& matrix) {
    checks_.accept(-1);
    if (matrix.rows() < matrix.cols())
      core::throw_joined<solver_error>({"qr: the matrix has ", static_cast<std::size_t>(matrix.rows()), " rows and ",
                                        static_cast<std::size_t>(matrix.cols()),
                                        " columns; it must have at least as many rows as columns"});
    Eigen::SparseMatrix<double> storage;
    const Eigen::SparseMatrix<double>& input = checks_.begin(matrix, storage);
    Eigen::SparseMatrix<double> a = without_empty_rows(input);
    column_scale_ = core::scale_columns(a);
    if (a.cols() > 0) {
      if (a.rows() < a.cols()) throw_dependent(first_empty_or_last_column(a));
      checks_.analyse_once(a, [&](const auto& m) { factors_.analyzePattern(m); });
      factors_.factorize(a);
      if (factors_.info() != Eigen::Success)
        core::throw_joined<solver_error>({"qr: the matrix cannot be factorised: ", factors_.lastErrorMessage()});
      if (factors_.rank() < a.cols()) throw_dependent(factors_.colsPermutation().indices()[factors_.rank()]);
    }
    checks_.accept(input.rows());
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
    return checks_.solve(right, [&](const Eigen::VectorXd& b) {
      if (column_scale_.empty()) return Eigen::VectorXd(0);
      Eigen::VectorXd kept(static_cast<Eigen::Index>(kept_.size()));
      for (Eigen::Index i = 0; i < kept.size(); ++i) kept[i] = b[kept_[static_cast<std::size_t>(i)]];
      const Eigen::VectorXd x = factors_.solve(kept);
      return Eigen::VectorXd(core::scaled(x, column_scale_));
    });
  }

 private:
  [[noreturn]] static void throw_dependent(Eigen::Index column) {
    core::throw_joined<solver_error>(
        {"qr: column ", static_cast<std::size_t>(column),
         " of the matrix is a combination of others to working precision, so that this unknown is not determined"});
  }

  static Eigen::Index first_empty_or_last_column(const Eigen::SparseMatrix<double>& a) {
    Eigen::Index c = 0;
    while (c + 1 < a.cols() && a.outerIndexPtr()[c] < a.outerIndexPtr()[c + 1]) ++c;
    return c;
  }

  Eigen::SparseMatrix<double> without_empty_rows(const Eigen::SparseMatrix<double>& a) {
    std::vector<int> new_row(static_cast<std::size_t>(a.rows()), -1);
    for (Eigen::Index k = 0; k < a.nonZeros(); ++k) new_row[static_cast<std::size_t>(a.innerIndexPtr()[k])] = 0;
    kept_.clear();
    for (std::size_t i = 0; i < new_row.size(); ++i)
      if (new_row[i] == 0) {
        new_row[i] = static_cast<int>(kept_.size());
        kept_.push_back(static_cast<int>(i));
      }
    Eigen::SparseMatrix<double> r(static_cast<Eigen::Index>(kept_.size()), a.cols());
    r.resizeNonZeros(a.nonZeros());
    for (Eigen::Index c = 0; c <= a.cols(); ++c) r.outerIndexPtr()[c] = a.outerIndexPtr()[c];
    for (Eigen::Index k = 0; k < a.nonZeros(); ++k) {
      r.innerIndexPtr()[k] = new_row[static_cast<std::size_t>(a.innerIndexPtr()[k])];
      r.valuePtr()[k] = a.valuePtr()[k];
    }
    return r;
  }
};

}  // namespace concino
