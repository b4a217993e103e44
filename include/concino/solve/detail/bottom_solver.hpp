// The direct solver of the coarsest level of multigrid.
#pragma once

#include <concino/solve/detail/multigrid_cycle.hpp>
#include <concino/solve/detail/ordered.hpp>
#include <concino/solve/detail/sparse_factor.hpp>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// A direct solve with a small matrix. Where a pivot is not positive, the diagonal entry is raised. So an unknown of each kernel vector of a singular matrix is
/// near 0 in the solution.
class bottom_solver {
  elimination_order order_;
  sparse_factor factors_;

 public:
  /// a: a lower triangle with a positive diagonal. Returns false if no factorisation was found, since entries are too large. has_kernel: set if a diagonal
  /// entry was raised.
  bool factorize(const Eigen::SparseMatrix<double>& a, bool& has_kernel) {
    const auto n = static_cast<std::size_t>(a.cols());
    order_.find(a);
    Eigen::SparseMatrix<double> upper = order_(a);
    factors_.analyse(upper, a.cols() * a.cols());
    std::vector<double*> diagonal(n);
    for (int c = 0; c < static_cast<int>(n); ++c)
      for (int k = upper.outerIndexPtr()[c]; k < upper.outerIndexPtr()[c + 1]; ++k)
        if (upper.innerIndexPtr()[k] == c) diagonal[static_cast<std::size_t>(c)] = upper.valuePtr() + k;
    for (std::size_t attempt = 0; attempt < 100 + 8 * n; ++attempt) {
      factors_.factorize(upper);
      std::size_t c = 0;
      while (c < n && factors_.pivots()[c] > 1e-13 * *diagonal[c] && std::isfinite(factors_.pivots()[c])) ++c;
      if (c == n) return true;
      *diagonal[c] *= attempt < n ? 2 : 64;
      has_kernel = true;
    }
    return false;
  }

  /// For W right-hand sides at once.
  template<int W>
  void solve(const double* b, double* x, double* y) const {
    const Eigen::SparseMatrix<double>& l = factors_.lower();
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
      for (int i = 0; i < W; ++i) sum[i] = row_of<W>(y, c)[i] / factors_.pivots()[static_cast<std::size_t>(c)];
      for (int k = starts[c]; k < starts[c + 1]; ++k)
        for (int i = 0; i < W; ++i) sum[i] -= entry[k] * row_of<W>(y, rows[k])[i];
      for (int i = 0; i < W; ++i) row_of<W>(x, row[c])[i] = row_of<W>(y, c)[i] = sum[i];
    }
  }
};

}  // namespace concino::detail
