// The direct solver of the coarsest level of multigrid.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/solve/detail/direct/ordered.hpp>
#include <concino/solve/detail/multigrid/multigrid_cycle.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace concino::detail {

/// A direct solve with a small matrix. Where a pivot is not positive, the diagonal entry is raised. So an unknown of
/// each kernel vector of a singular matrix is near 0 in the solution.
class bottom_solver {
  elimination_order order_;
  Eigen::SparseMatrix<double> lower_;  // of L D L^T in this order: the entries of L below the diagonal
  std::vector<double> pivots_;          // D

 public:
  /// a: a lower triangle with a positive diagonal. Returns false if no factorisation was found, since entries are too
  /// large. has_kernel: set if a diagonal entry was raised.
  bool factorize(const Eigen::SparseMatrix<double>& a, bool& has_kernel);

  /// For W right-hand sides at once.
  template<int W>
  void solve(const double* b, double* x, double* y) const {
    const Eigen::SparseMatrix<double>& l = lower_;
    const auto n = static_cast<int>(l.cols());
    const int *const starts = l.outerIndexPtr(), *const rows = l.innerIndexPtr(), *const row = order_.row.data();
    const double* const entry = l.valuePtr();
    for (int c = 0; c < n; ++c)
      for (int i = 0; i < W; ++i) row_of<W>(y, c)[i] = row_of<W>(b, row[c])[i];
    for (int c = 0; c < n; ++c)
      for (int k = starts[c]; k < starts[c + 1]; ++k)
        for (int i = 0; i < W; ++i) row_of<W>(y, rows[k])[i] -= entry[k] * row_of<W>(y, c)[i];
    for (int c = n - 1; c >= 0; --c) {
      double sum[W];
      for (int i = 0; i < W; ++i) sum[i] = row_of<W>(y, c)[i] / pivots_[static_cast<std::size_t>(c)];
      for (int k = starts[c]; k < starts[c + 1]; ++k)
        for (int i = 0; i < W; ++i) sum[i] -= entry[k] * row_of<W>(y, rows[k])[i];
      for (int i = 0; i < W; ++i) row_of<W>(x, row[c])[i] = row_of<W>(y, c)[i] = sum[i];
    }
  }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/solve/detail/multigrid/bottom_solver.ipp>
#endif
