// Sparse matrices whose columns are sorted by rows.
#pragma once

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace concino::detail {

/// The transpose, with sorted columns. So the transpose of an upper triangle is a lower one whose columns begin with the diagonal.
inline Eigen::SparseMatrix<double> sorted_transpose(const Eigen::SparseMatrix<double>& a) {
  const auto n = static_cast<int>(a.rows());
  Eigen::SparseMatrix<double> r(a.cols(), n);
  r.resizeNonZeros(a.nonZeros());
  std::vector<int> next(static_cast<std::size_t>(n) + 1);
  for (Eigen::Index k = 0; k < a.nonZeros(); ++k) ++next[static_cast<std::size_t>(a.innerIndexPtr()[k]) + 1];
  for (std::size_t i = 1; i < next.size(); ++i) r.outerIndexPtr()[i] = next[i] += next[i - 1];
  for (int c = 0; c < a.cols(); ++c)
    for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k) {
      const int at = next[static_cast<std::size_t>(a.innerIndexPtr()[k])]++;
      r.innerIndexPtr()[at] = c;
      r.valuePtr()[at] = a.valuePtr()[k];
    }
  return r;
}

/// Sorts the entries of each column of a square matrix by rows: short columns in place, by insertion, others by transposing twice.
inline void sort_columns(Eigen::SparseMatrix<double>& a) {
  const auto n = static_cast<int>(a.cols());
  const int* const starts = a.outerIndexPtr();
  int* const rows = a.innerIndexPtr();
  double* const x = a.valuePtr();
  constexpr double short_column = 64;  // entries
  double moves = 0;
  for (int c = 0; c < n; ++c) moves += static_cast<double>(starts[c + 1] - starts[c]) * (starts[c + 1] - starts[c]);
  if (moves > short_column * static_cast<double>(a.nonZeros())) {
    sorted_transpose(a).swap(a);
    sorted_transpose(a).swap(a);
    return;
  }
  for (int c = 0; c < n; ++c)
    for (int k = starts[c] + 1; k < starts[c + 1]; ++k) {
      const int row = rows[k];
      const double entry = x[k];
      int to = k;
      for (; to > starts[c] && rows[to - 1] > row; --to) {
        rows[to] = rows[to - 1];
        x[to] = x[to - 1];
      }
      rows[to] = row;
      x[to] = entry;
    }
}

/// Replaces entries at the same place, in a matrix with sorted columns, by their sum, and frees the memory that is left over.
inline void add_up_equal_rows(Eigen::SparseMatrix<double>& a) {
  int *const starts = a.outerIndexPtr(), *const rows = a.innerIndexPtr(), size = 0;
  double* const x = a.valuePtr();
  for (Eigen::Index c = 0, k = 0; c < a.cols(); ++c) {
    const int first = size;
    for (; k < starts[c + 1]; ++k) {
      if (size > first && rows[size - 1] == rows[k]) {
        x[size - 1] += x[k];
      } else {
        rows[size] = rows[k];
        x[size++] = x[k];
      }
    }
    starts[c + 1] = size;
  }
  a.resizeNonZeros(size);
  a.data().squeeze();
}

}  // namespace concino::detail
