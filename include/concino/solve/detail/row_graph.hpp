// The graph of a symmetric matrix, for elimination orders.
#pragma once

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// An array with one value per row of a matrix, or per entry.
template<class T>
struct row_array {
  std::vector<T> values;

  int size() const { return static_cast<int>(values.size()); }
  T& operator[](int i) { return values[static_cast<std::size_t>(i)]; }
  const T& operator[](int i) const { return values[static_cast<std::size_t>(i)]; }
  void assign(int n, T x) { values.assign(static_cast<std::size_t>(n), x); }
  auto begin() const { return values.begin(); }
  auto end() const { return values.end(); }
};

/// The adjacent rows of each row of a symmetric matrix, without rows that have very many entries. Rows are numbered breadth first, so that adjacent rows
/// are close in memory.
struct row_graph {
  row_array<int> starts, adjacent;
  row_array<int> input_row;  // the number of each row in the matrix
  row_array<int> dense;      // the rows of the matrix that are left out

  explicit row_graph(const Eigen::SparseMatrix<double>& pattern) {
    const int *const begin = pattern.outerIndexPtr(), *const rows = pattern.innerIndexPtr(), n = static_cast<int>(pattern.cols());
    const double max_entries = std::max(16.0, 10 * std::sqrt(static_cast<double>(n)));
    row_array<int> number;
    number.assign(n, -1);
    const auto is_dense = [&](int r) { return begin[r + 1] - begin[r] > max_entries; };
    const auto add = [&](int r) {
      if (number[r] >= 0 || is_dense(r)) return;
      number[r] = input_row.size();
      input_row.values.push_back(r);
    };
    for (int r = 0; r < n; ++r) {
      if (is_dense(r)) dense.values.push_back(r);
      const int first = input_row.size();
      add(r);
      for (int i = first; i < input_row.size(); ++i)
        for (int k = begin[input_row[i]], end = begin[input_row[i] + 1]; k < end; ++k) add(rows[k]);
    }
    starts.values.assign(1, 0);
    adjacent.values.reserve(static_cast<std::size_t>(pattern.nonZeros()));
    for (const int r : input_row) {
      for (int k = begin[r]; k < begin[r + 1]; ++k)
        if (rows[k] != r && number[rows[k]] >= 0) adjacent.values.push_back(number[rows[k]]);
      starts.values.push_back(adjacent.size());
    }
  }

  int num_rows() const { return input_row.size(); }
};

}  // namespace concino::detail
