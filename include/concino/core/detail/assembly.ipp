// Assembly of columns of matrices; see assembly.hpp.
#pragma once

#include <concino/core/assembly.hpp>
#include <concino/core/error.hpp>

#include <cstddef>
#include <limits>
#include <utility>

namespace concino::core {

CONCINO_INLINE void sort_column(int* rows, double* values, std::size_t n) {
  if (n <= 32) {
    for (std::size_t i = 1; i < n; ++i) {
      const int row = rows[i];
      const double value = values[i];
      std::size_t j = i;
      for (; j > 0 && rows[j - 1] > row; --j) {
        rows[j] = rows[j - 1];
        values[j] = values[j - 1];
      }
      rows[j] = row;
      values[j] = value;
    }
    return;
  }
  // heap sort, because there are two arrays: the first entry sinks below those with larger rows
  const auto sink = [&](std::size_t i, std::size_t end) {
    const int row = rows[i];
    const double value = values[i];
    for (std::size_t below = 2 * i + 1; below < end; i = below, below = 2 * i + 1) {
      if (below + 1 < end && rows[below] < rows[below + 1]) ++below;
      if (rows[below] <= row) break;
      rows[i] = rows[below];
      values[i] = values[below];
    }
    rows[i] = row;
    values[i] = value;
  };
  for (std::size_t i = n / 2; i-- > 0;) sink(i, n);
  for (std::size_t end = n - 1; end > 0; --end) {
    std::swap(rows[0], rows[end]);
    std::swap(values[0], values[end]);
    sink(0, end);
  }
}

CONCINO_INLINE void check_rows(std::size_t size) {
  if (size >= static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw unsupported("assembly: the matrix would have more rows than its 32-bit indices can count");
}

CONCINO_INLINE void make_room_for_counted(Eigen::SparseMatrix<double>& a) {
  int* const begin = a.outerIndexPtr();
  std::size_t entries = 0;
  for (Eigen::Index c = 1; c <= a.cols(); ++c) entries += static_cast<std::size_t>(begin[c]);
  if (entries > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw unsupported("assembly: the matrix would have more entries than its 32-bit indices can count");
  for (Eigen::Index c = 0; c < a.cols(); ++c) begin[c + 1] += begin[c];
  a.resizeNonZeros(static_cast<Eigen::Index>(entries));
}

}  // namespace concino::core
