// L D L^T of a sparse symmetric matrix, row by row. Eigen has the same; what is here is the part of it that compiles in no time.
#pragma once

#include <concino/error.hpp>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::detail {

/// With P the fill-reducing order of elimination, P A P^T = L D L^T: L has ones on its diagonal, which are not kept, and is stored by columns.
/// Only the lower triangle of A counts.
/// Source: Davis 2005, "Algorithm 849: a concise sparse Cholesky factorization package"; the order: Amestoy, Davis, Duff 1996.
class elimination {
  std::vector<int> place_;  // of each row of A in the order of elimination
  std::vector<int> begin_;  // of the columns of L, and where the last ends
  std::vector<int> rows_;
  std::vector<double> entries_;
  std::vector<double> pivots_;

  /// What column j of A has at and below the diagonal: f(row, entry).
  template<class F>
  static void for_lower(const Eigen::SparseMatrix<double>& a, int j, const F& f) {
    const int* const sizes = a.innerNonZeroPtr();  // null: compressed
    const int from = a.outerIndexPtr()[j], to = sizes ? from + sizes[j] : a.outerIndexPtr()[j + 1];
    for (int k = from; k < to; ++k)
      if (a.innerIndexPtr()[k] >= j) f(a.innerIndexPtr()[k], a.valuePtr()[k]);
  }

  /// From the pattern of A with both triangles.
  void find_order(const Eigen::SparseMatrix<double>& a, int n) {
    Eigen::SparseMatrix<double> whole(n, n);
    int* const begin = whole.outerIndexPtr();
    for (int j = 0; j < n; ++j)
      for_lower(a, j, [&](int i, double) {
        ++begin[j + 1];
        if (i != j) ++begin[i + 1];
      });
    add_up(begin, n);
    whole.resizeNonZeros(begin[n]);
    std::vector<int> next(begin, begin + n);
    int* const at = next.data();
    int* const rows = whole.innerIndexPtr();
    for (int j = 0; j < n; ++j)
      for_lower(a, j, [&](int i, double) {
        rows[at[j]++] = i;
        if (i != j) rows[at[i]++] = j;
      });
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::internal::minimum_degree_ordering(whole, order);
    place_.resize(next.size());
    for (int k = 0; k < n; ++k) place_.data()[order.indices()[k]] = k;
  }

  /// Turns counts[i + 1] = size of list i into where each begins.
  static void add_up(int* counts, int n) {
    std::int64_t sum = 0;
    for (int i = 0; i < n; ++i) {
      sum += counts[i + 1];
      if (sum > std::numeric_limits<int>::max()) throw unsupported("ldlt: the factor would have more entries than its 32-bit indices can count");
      counts[i + 1] = static_cast<int>(sum);
    }
  }

 public:
  double pivot(Eigen::Index row) const { return pivots_.data()[place_.data()[row]]; }

  /// Result: false if a pivot is 0.
  /// Errors: unsupported if there are more entries than indices can count.
  bool factorize(const Eigen::SparseMatrix<double>& a) {
    const int n = static_cast<int>(a.cols());
    const auto size = static_cast<std::size_t>(n);
    find_order(a, n);
    const int* const place = place_.data();

    // the upper triangle of P A P^T by columns, rows in any order
    std::vector<int> upper_begin(size + 1);
    int* const from = upper_begin.data();
    for (int j = 0; j < n; ++j) for_lower(a, j, [&](int i, double) { ++from[std::max(place[i], place[j]) + 1]; });
    add_up(from, n);
    std::vector<int> next_entry = upper_begin, upper_rows(static_cast<std::size_t>(from[n]));
    std::vector<double> upper_entries(upper_rows.size());
    int* const next = next_entry.data();
    int* const upper_row = upper_rows.data();
    double* const upper = upper_entries.data();
    for (int j = 0; j < n; ++j)
      for_lower(a, j, [&](int i, double x) {
        const int at = next[std::max(place[i], place[j])]++;
        upper_row[at] = std::min(place[i], place[j]);
        upper[at] = x;
      });

    // Row k of L has its entries on the ways up the elimination tree from the entries of column k.
    std::vector<int> parents(size, -1), seen_in(size, -1), patterns(size);
    int* const parent = parents.data();
    int* const seen = seen_in.data();
    int* const pattern = patterns.data();
    begin_ = std::vector<int>(size + 1);
    int* const begin = begin_.data();
    for (int k = 0; k < n; ++k) {
      seen[k] = k;
      for (int l = from[k]; l < from[k + 1]; ++l)
        for (int i = upper_row[l]; seen[i] != k; i = parent[i]) {
          if (parent[i] < 0) parent[i] = k;
          ++begin[i + 1];
          seen[i] = k;
        }
    }
    add_up(begin, n);

    rows_.resize(static_cast<std::size_t>(begin[n]));
    entries_.resize(rows_.size());
    pivots_.resize(size);
    int* const rows = rows_.data();
    double* const entries = entries_.data();
    double* const pivots = pivots_.data();
    std::vector<double> row(size);  // k of L D as it comes to be, 0 where it has no entry
    double* const y = row.data();
    for (int k = 0; k < n; ++k) {
      next[k] = begin[k];
      seen[k] = -1;
    }
    for (int k = 0; k < n; ++k) {
      int top = n;  // from here on `pattern` is where row k has entries, children before parents
      seen[k] = k;
      for (int l = from[k]; l < from[k + 1]; ++l) {
        int i = upper_row[l], length = 0;
        y[i] += upper[l];
        for (; seen[i] != k; i = parent[i]) {
          pattern[length++] = i;
          seen[i] = k;
        }
        while (length > 0) pattern[--top] = pattern[--length];
      }
      double pivot = y[k];
      y[k] = 0;
      for (; top < n; ++top) {
        const int i = pattern[top], end = next[i]++;
        const double yi = y[i], entry = yi / pivots[i];
        y[i] = 0;
        for (int l = begin[i]; l < end; ++l) y[rows[l]] -= entries[l] * yi;
        pivot -= entry * yi;
        rows[end] = k;
        entries[end] = entry;
      }
      pivots[k] = pivot;
      if (pivot == 0) return false;
    }
    return true;
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    const auto n = static_cast<int>(pivots_.size());
    const int* const place = place_.data();
    const int* const begin = begin_.data();
    const int* const rows = rows_.data();
    const double* const entries = entries_.data();
    std::vector<double> permuted(pivots_.size());
    double* const y = permuted.data();
    for (int i = 0; i < n; ++i) y[place[i]] = b[i];
    for (int c = 0; c < n; ++c) {
      const double yc = y[c];
      for (int l = begin[c]; l < begin[c + 1]; ++l) y[rows[l]] -= entries[l] * yc;
    }
    for (int c = n - 1; c >= 0; --c) {
      double yc = y[c] / pivots_.data()[c];
      for (int l = begin[c]; l < begin[c + 1]; ++l) yc -= entries[l] * y[rows[l]];
      y[c] = yc;
    }
    Eigen::VectorXd x(n);
    for (int i = 0; i < n; ++i) x[i] = y[place[i]];
    return x;
  }
};

}  // namespace concino::detail
