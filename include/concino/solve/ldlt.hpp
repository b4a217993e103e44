// Symmetric sparse systems by factorisation.
#pragma once

#include <concino/detail/number_text.hpp>
#include <concino/error.hpp>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace concino {

/// Factorises a symmetric matrix as L D L^T, fill-reducing, and solves with it. A SparseSolver; the default of all problems.
/// Only the lower triangle of the matrix is read.
/// Errors: solver_error, with the reason, from factorize if the matrix is not square, has entries that are not finite, or is singular;
///         from solve if nothing was factorised, the right-hand side has another size or the solution is not finite.
/// Source: Eigen's SimplicialLDLT with approximate minimum degree ordering (Amestoy, Davis, Duff 1996).
class ldlt {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
  Eigen::Index size_ = -1;

 public:
  void factorize(const Eigen::SparseMatrix<double>& a) {
    size_ = -1;
    if (a.rows() != a.cols())
      throw solver_error("ldlt: the matrix has " + detail::number_text(a.rows()) + " rows and " + detail::number_text(a.cols()) + " columns; it must be square");
    // a pivot is a diagonal entry minus what elimination takes away: where nothing but rounding errors is left, it says nothing
    std::vector<double> diagonal(static_cast<std::size_t>(a.cols()));
    for (int c = 0; c < a.cols(); ++c)
      for (Eigen::SparseMatrix<double>::InnerIterator it(a, c); it; ++it) {
        if (!std::isfinite(it.value())) throw solver_error("ldlt: the matrix has an entry that is not finite");
        if (it.row() == c) diagonal[static_cast<std::size_t>(c)] += it.value();
      }
    if (a.cols() == 0) {
      size_ = 0;
      return;
    }
    factors_.compute(a);
    if (factors_.info() != Eigen::Success) throw solver_error("ldlt: the matrix is singular: a pivot is 0");
    const Eigen::VectorXd pivots = factors_.vectorD();
    const auto& place = factors_.permutationP().indices();
    for (Eigen::Index c = 0; c < a.cols(); ++c) {
      const double pivot = std::abs(pivots[place[c]]), given = std::abs(diagonal[static_cast<std::size_t>(c)]);
      if (!(pivot > 1e-15 * given && pivot < std::numeric_limits<double>::infinity()))
        throw solver_error("ldlt: the matrix is singular to working precision in row " + detail::number_text(c) + ": of the diagonal entry " +
                           detail::number_text(given) + " elimination leaves " + detail::number_text(pivot));
    }
    size_ = a.rows();
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    if (size_ < 0) throw solver_error("ldlt: solve without a factorised matrix; call factorize first");
    if (b.size() != size_)
      throw solver_error("ldlt: the right-hand side has " + detail::number_text(b.size()) + " entries, the matrix " + detail::number_text(size_) + " rows");
    if (size_ == 0) return Eigen::VectorXd(0);
    Eigen::VectorXd x = factors_.solve(b);
    for (Eigen::Index i = 0; i < x.size(); ++i)
      if (!std::isfinite(x[i])) throw solver_error("ldlt: the solution is not finite; the matrix is singular or the right-hand side is not finite");
    return x;
  }
};

}  // namespace concino
