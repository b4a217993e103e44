// The L D L^T factors of a symmetric matrix.
#pragma once

#include <concino/core/error.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::detail {

/// L with ones on the diagonal and a diagonal D. Their product is a symmetric matrix, passed as its upper triangle, compressed, in its own order. Uses loops
/// over flat arrays, because Eigen's SimplicialLDLT takes as long to compile as everything else in a small program.
/// Source: Davis, Algorithm 849, 2005.
class sparse_factor {
  std::vector<int> parent_;  // of each column in the elimination tree; -1 for roots
  Eigen::SparseMatrix<double> l_;
  std::vector<double> pivots_;

 public:
  /// The entries of L below the diagonal.
  const Eigen::SparseMatrix<double>& lower() const { return l_; }
  /// The diagonal D, up to the first 0.
  const std::vector<double>& pivots() const { return pivots_; }

  /// The number of multiplications of factorize, up to the order of n, for the analysed pattern.
  std::int64_t num_multiplications() const {
    std::int64_t sum = 0;
    for (Eigen::Index c = 0; c < l_.cols(); ++c) {
      const std::int64_t entries = l_.outerIndexPtr()[c + 1] - l_.outerIndexPtr()[c];
      sum += entries * entries;
    }
    return sum;
  }

  /// Finds the pattern of L. Returns false, and finds nothing, if it has more than `most` entries below the diagonal.
  /// Cost:   as many steps as entries counted, a small part of a factorisation.
  bool analyse(const Eigen::SparseMatrix<double>& upper, std::int64_t most) {
    const int n = static_cast<int>(upper.cols());
    most = std::min<std::int64_t>(most, std::numeric_limits<int>::max());
    Eigen::SparseMatrix<double>().swap(l_);
    parent_.assign(static_cast<std::size_t>(n), -1);
    std::vector<int> seen(static_cast<std::size_t>(n), -1);
    Eigen::SparseMatrix<double> l(n, n);
    int* const count = l.outerIndexPtr() + 1;  // of entries of each column
    std::int64_t entries = 0;
    for (int c = 0; c < n; ++c) {
      seen[static_cast<std::size_t>(c)] = c;
      for (int k = upper.outerIndexPtr()[c]; k < upper.outerIndexPtr()[c + 1]; ++k)
        for (auto i = static_cast<std::size_t>(upper.innerIndexPtr()[k]); seen[i] != c; i = static_cast<std::size_t>(parent_[i])) {
          if (parent_[i] < 0) parent_[i] = c;
          seen[i] = c;
          ++count[i];
          ++entries;
        }
      if (entries > most) return false;
    }
    for (int c = 1; c < n; ++c) count[c] += count[c - 1];
    l.resizeNonZeros(static_cast<Eigen::Index>(entries));
    l_.swap(l);
    return true;
  }

  /// Computes the factors of a matrix of the analysed pattern, one row of L after another: each solves with the rows above. Stops at a pivot of 0.
  void factorize(const Eigen::SparseMatrix<double>& upper) {
    const int n = static_cast<int>(upper.cols());
    const int *const begin = l_.outerIndexPtr(), *const from = upper.innerIndexPtr(), *const parent = parent_.data();
    int* const rows = l_.innerIndexPtr();
    double* const values = l_.valuePtr();
    pivots_.resize(static_cast<std::size_t>(n));
    std::vector<int> end(begin, begin + n), seen(static_cast<std::size_t>(n), -1), columns(static_cast<std::size_t>(n));
    std::vector<double> sums(static_cast<std::size_t>(n));
    int *const ends = end.data(), *const last_seen = seen.data(), *const column = columns.data();
    double *const y = sums.data(), *const d = pivots_.data();  // y: the remainder of row r; 0 elsewhere
    for (int r = 0; r < n; ++r) {
      int first = n;  // the columns in which the row has entries, each before its parent, are column[first, n)
      last_seen[r] = r;
      for (int k = upper.outerIndexPtr()[r]; k < upper.outerIndexPtr()[r + 1]; ++k) {
        int i = from[k], length = 0;
        y[i] += upper.valuePtr()[k];
        for (; last_seen[i] != r; i = parent[i]) {
          column[length++] = i;
          last_seen[i] = r;
        }
        while (length > 0) column[--first] = column[--length];
      }
      double pivot = y[r];
      y[r] = 0;
      for (; first < n; ++first) {
        const int c = column[first], at = ends[c]++;
        const double left = y[c], entry = left / d[c];
        y[c] = 0;
        for (int k = begin[c]; k < at; ++k) y[rows[k]] -= values[k] * left;
        pivot -= entry * left;
        rows[at] = r;
        values[at] = entry;
      }
      d[r] = pivot;
      if (pivot == 0) return;
    }
  }
};

}  // namespace concino::detail
