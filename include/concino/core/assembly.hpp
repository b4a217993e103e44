// Weights on edges as a sparse matrix, filled straight into compressed columns: no list of triplets, each weight read as it is needed.
#pragma once

#include <concino/concepts/primal_graph.hpp>
#include <concino/core/error.hpp>
#include <concino/core/parallel.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <limits>
#include <utility>

namespace concino::core {

/// Sorts a column by row. Columns are short but for the hubs of fans, so both are served.
inline void sort_column(int* rows, double* values, std::size_t n) {
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
  // a heap, because there are two arrays: the first of them sinks below those with larger rows
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

/// Every entry, where every vert has a column.
struct whole_matrix {
  static constexpr bool is_whole = true;
  static constexpr bool wants(int, int) { return true; }
};
struct lower_triangle {
  static constexpr bool is_whole = false;
  static constexpr bool wants(int row, int column) { return row >= column; }
};

/// The matrix with `sign` times the sum of the weights at a vert on the diagonal and minus `sign` times the weights beside it.
/// column(v) is the row and column of vert v, negative where it has none: such a neighbour adds to the diagonal and is reported to
/// outside(column of v, neighbour, weight), by several threads for different v. Part says which triangle is wanted. Verts may come in any order.
template<class Part, class M, class W, class Column, class Outside>
Eigen::SparseMatrix<double> assemble(const M& m, const W& weights, std::size_t size, double sign, const Column& column, const Outside& outside) {
  if (size >= static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw unsupported("assembly: the matrix would have more rows than its 32-bit indices can count");
  Eigen::SparseMatrix<double> a(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
  int* const begin = a.outerIndexPtr();
  std::size_t entries = 0;
  for (const vert_t<M> v : verts(m)) {
    const int c = column(v);
    if (c < 0) continue;
    int n = 1;
    if constexpr (Part::is_whole) {
      n += weights.num_neighbours(v);
    } else {
      weights.for_each_neighbour(v, [&](const vert_t<M>& w, double) {
        if (const int r = column(w); r >= 0 && Part::wants(r, c)) ++n;
      });
    }
    begin[c + 1] = n;
    entries += static_cast<std::size_t>(n);
  }
  if (entries > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw unsupported("assembly: the matrix would have more entries than its 32-bit indices can count");
  for (std::size_t c = 0; c < size; ++c) begin[c + 1] += begin[c];
  a.resizeNonZeros(static_cast<Eigen::Index>(entries));
  int* const rows = a.innerIndexPtr();
  double* const values = a.valuePtr();
  parallel_for_each(verts(m), [&](const vert_t<M>& v) {  // each vert writes its own column
    const int c = column(v);
    if (c < 0) return;
    const std::size_t first = static_cast<std::size_t>(begin[c]);
    std::size_t at = first + 1;
    double diagonal = 0;
    weights.for_each_neighbour(v, [&](const vert_t<M>& w, double weight) {
      diagonal += weight;
      const int r = column(w);
      if (r < 0) return outside(c, w, weight);
      if (!Part::wants(r, c)) return;
      rows[at] = r;
      values[at++] = -sign * weight;
    });
    rows[first] = c;
    values[first] = sign * diagonal;
    sort_column(rows + first, values + first, at - first);
  });
  return a;
}

}  // namespace concino::core
