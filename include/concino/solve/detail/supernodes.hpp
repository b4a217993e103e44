// Substitution with a sparse factor by supernodes, many columns at a time.
#pragma once

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// Supernodes: neighbouring columns of a factor with entries in the same rows below them, so that each such block is dense. The values that
/// multiply it are gathered, and rows are read once per block. The factor is not changed: the values of each column end with those in the common rows.
/// Source: Ng, Peyton 1993, "Block sparse Cholesky algorithms on advanced uniprocessor computers".
class supernodes {
  std::vector<int> begin_;  // the first column of each supernode, and the number of columns
  std::size_t largest_ = 0;  // number of columns and common rows of the largest supernode

  /// The columns of one supernode: column i has entries in rows i + 1, ..., height - 1; the last of these are the common rows.
  struct block {
    const int* starts;
    const double* values;
    int width, height;

    /// The entry of a column in a row below it.
    const double* entry(int row, int column) const { return values + starts[column] + (row - column - 1); }

    /// Prefetches for solve_upper, which reads columns last to first; hardware does not predict that.
    void prefetch_before(int i, int count) const {
#if defined(__GNUC__)
      constexpr int ahead = 1024, in_a_cache_line = 8;
      for (int k = std::max(starts[i] - ahead, 0); k < starts[i + count] - ahead; k += in_a_cache_line) __builtin_prefetch(values + k);
#else
      (void)i, (void)count;
#endif
    }

    /// Forward substitution with columns i, ..., i + count - 1; y: the values of the rows.
    template<int count>
    void subtract(int i, double* y) const {
      const int below = i + count;
      const double* v[count];
      double factor[count];
      for (int j = 0; j < count; ++j) {
        v[j] = entry(below, i + j);
        for (int l = 0; l < j; ++l) y[i + j] -= *entry(i + j, i + l) * factor[l];
        factor[j] = y[i + j];
      }
      for (int k = 0; k < height - below; ++k) {
        double sum = v[0][k] * factor[0];
        for (int j = 1; j < count; ++j) sum += v[j][k] * factor[j];
        y[below + k] -= sum;
      }
    }

    /// Backward substitution with these columns.
    template<int count>
    void collect(int i, double* y) const {
      constexpr int lanes = 4;  // independent sums that the processor can compute at once
      const int below = i + count, n = height - below;
      const double *v[count], *const x = y + below;
      double sum[count][lanes] = {};
      for (int j = 0; j < count; ++j) v[j] = entry(below, i + j);
      int k = 0;
      for (; k + lanes <= n; k += lanes)
        for (int j = 0; j < count; ++j)
          for (int l = 0; l < lanes; ++l) sum[j][l] += v[j][k + l] * x[k + l];
      for (; k < n; ++k)
        for (int j = 0; j < count; ++j) sum[j][0] += v[j][k] * x[k];
      for (int j = count; j-- > 0;) {
        y[i + j] -= (sum[j][0] + sum[j][1]) + (sum[j][2] + sum[j][3]);
        for (int l = 0; l < j; ++l) sum[l][0] += *entry(i + j, i + l) * y[i + j];
      }
    }
  };

 public:
  /// l: strictly lower triangular, compressed, rows sorted within columns.
  void find(const Eigen::SparseMatrix<double>& l) {
    const int *const starts = l.outerIndexPtr(), n = static_cast<int>(l.cols());
    begin_.clear();
    largest_ = 0;
    for (int c = 0; c < n; ++c) {
      const bool continues = c > 0 && starts[c] - starts[c - 1] == starts[c + 1] - starts[c] + 1 && l.innerIndexPtr()[starts[c - 1]] == c;
      if (!continues) {
        begin_.push_back(c);
        largest_ = std::max(largest_, static_cast<std::size_t>(starts[c + 1] - starts[c]) + 1);
      }
    }
    begin_.push_back(n);
  }

  /// x = (1 + l)^-1 x for the l passed to find. Skips columns where x is 0 and stays 0.
  void solve_lower(const Eigen::SparseMatrix<double>& l, Eigen::VectorXd& solution) const {
    double* const x = solution.data();
    std::vector<double> copies(largest_);
    double* const y = copies.data();
    for (std::size_t s = 0; s + 1 < begin_.size(); ++s) {
      const int c = begin_[s], width = begin_[s + 1] - c, *const starts = l.outerIndexPtr() + c, *const rows = l.innerIndexPtr() + starts[width - 1];
      const int common = starts[width] - starts[width - 1];
      if (width == 1) {
        if (x[c] == 0) continue;
        const double *const v = l.valuePtr() + starts[0], factor = x[c];
        for (int k = 0; k < common; ++k) x[rows[k]] -= v[k] * factor;
        continue;
      }
      const block b{starts, l.valuePtr(), width, width + common};
      int i = 0;
      while (i < width && x[c + i] == 0) ++i;
      if (i == width) continue;
      for (int k = 0; k < width; ++k) y[k] = x[c + k];
      for (int k = width; k < b.height; ++k) y[k] = 0;
      for (; i + 4 <= width; i += 4) b.subtract<4>(i, y);
      if (i + 3 == width) b.subtract<3>(i, y);
      if (i + 2 == width) b.subtract<2>(i, y);
      if (i + 1 == width) b.subtract<1>(i, y);
      for (int k = 0; k < width; ++k) x[c + k] = y[k];
      for (int k = 0; k < common; ++k) x[rows[k]] += y[width + k];
    }
  }

  /// x = (1 + l^T)^-1 x.
  void solve_upper(const Eigen::SparseMatrix<double>& l, Eigen::VectorXd& solution) const {
    double* const x = solution.data();
    std::vector<double> copies(largest_);
    double* const y = copies.data();
    for (std::size_t s = begin_.size() - 1; s-- > 0;) {
      const int c = begin_[s], width = begin_[s + 1] - c, *const starts = l.outerIndexPtr() + c, *const rows = l.innerIndexPtr() + starts[width - 1];
      const int common = starts[width] - starts[width - 1];
      const block b{starts, l.valuePtr(), width, width + common};
      if (width == 1) {
        b.prefetch_before(0, 1);
        const double* const v = l.valuePtr() + starts[0];
        double sum = 0;
        for (int k = 0; k < common; ++k) sum += v[k] * x[rows[k]];
        x[c] -= sum;
        continue;
      }
      for (int k = 0; k < width; ++k) y[k] = x[c + k];
      for (int k = 0; k < common; ++k) y[width + k] = x[rows[k]];
      int i = width;
      for (; i >= 4; i -= 4) {
        b.prefetch_before(i - 4, 4);
        b.collect<4>(i - 4, y);
      }
      b.prefetch_before(0, i);
      if (i == 3) b.collect<3>(0, y);
      if (i == 2) b.collect<2>(0, y);
      if (i == 1) b.collect<1>(0, y);
      for (int k = 0; k < width; ++k) x[c + k] = y[k];
    }
  }
};

}  // namespace concino::detail
