// A fill-reducing elimination order of a symmetric matrix.
#pragma once

#include <concino/solve/detail/sorted_columns.hpp>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino::detail {

/// Computes an approximate minimum degree order (Amestoy, Davis, Duff 1996) and keeps it for further matrices of the same pattern. Uses loops, because
/// Eigen's expressions take long to compile.
struct elimination_order {
  std::vector<int> position;  // of each row
  std::vector<int> row;       // at each position: the inverse

  /// Stores an order. row_at: the row at each position.
  void keep(std::vector<int> row_at) {
    std::vector<int> new_position(row_at.size());
    for (std::size_t i = 0; i < row_at.size(); ++i) new_position[static_cast<std::size_t>(row_at[i])] = static_cast<int>(i);
    row.swap(row_at);
    position.swap(new_position);
  }

  /// Computes the order. It depends only on the pattern of a, which is compressed, in either triangle.
  void find(const Eigen::SparseMatrix<double>& a) {
    Eigen::SparseMatrix<double> pattern = symmetric_pattern(a);
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::internal::minimum_degree_ordering(pattern, order);
    const int* const row_at = order.indices().data();
    keep(std::vector<int>(row_at, row_at + a.cols()));
  }

  /// The upper triangle of the reordered matrix, from the lower one of a, which is compressed.
  Eigen::SparseMatrix<double> operator()(const Eigen::SparseMatrix<double>& a) const { return triangle<true>(a); }

  /// Its lower triangle, with sorted columns.
  Eigen::SparseMatrix<double> lower(const Eigen::SparseMatrix<double>& a) const {
    Eigen::SparseMatrix<double> r = triangle<false>(a);
    sort_columns(r);
    return r;
  }

  /// A pattern with an entry, of any value, wherever a or its transpose has one.
  static Eigen::SparseMatrix<double> symmetric_pattern(const Eigen::SparseMatrix<double>& a) {
    const int *const starts = a.outerIndexPtr(), *const rows = a.innerIndexPtr(), n = static_cast<int>(a.cols());
    std::vector<int> row_begin(static_cast<std::size_t>(n) + 1), column(static_cast<std::size_t>(a.nonZeros()));  // the transpose
    for (Eigen::Index k = 0; k < a.nonZeros(); ++k) ++row_begin[static_cast<std::size_t>(rows[k]) + 1];
    for (std::size_t i = 1; i < row_begin.size(); ++i) row_begin[i] += row_begin[i - 1];
    std::vector<int> next(row_begin.begin(), row_begin.end() - 1);
    for (int c = 0; c < n; ++c)
      for (int k = starts[c]; k < starts[c + 1]; ++k) column[static_cast<std::size_t>(next[static_cast<std::size_t>(rows[k])]++)] = c;
    Eigen::SparseMatrix<double> pattern(n, n);
    pattern.resizeNonZeros(2 * a.nonZeros());
    int *const begin = pattern.outerIndexPtr(), *const to = pattern.innerIndexPtr(), at = 0;
    for (int c = 0; c < n; ++c) {  // both are sorted, so they can be merged
      const int *up = column.data() + row_begin[static_cast<std::size_t>(c)], *const up_end = column.data() + row_begin[static_cast<std::size_t>(c) + 1];
      const int *down = rows + starts[c], *const down_end = rows + starts[c + 1];
      while (up != up_end || down != down_end) {
        const int row = up == up_end ? *down : down == down_end ? *up : std::min(*up, *down);
        if (up != up_end && *up == row) ++up;
        if (down != down_end && *down == row) ++down;
        to[at++] = row;
      }
      begin[c + 1] = at;
    }
    pattern.resizeNonZeros(at);
    return pattern;
  }

 private:
  template<bool is_upper>
  Eigen::SparseMatrix<double> triangle(const Eigen::SparseMatrix<double>& a) const {
    const int *const starts = a.outerIndexPtr(), *const rows = a.innerIndexPtr(), *const to = position.data();
    const auto n = static_cast<int>(a.cols());
    const auto column_of = [](int i, int j) { return is_upper ? std::max(i, j) : std::min(i, j); };
    Eigen::SparseMatrix<double> r(n, n);
    int* const next = r.outerIndexPtr();  // entry c + 1, for column c: first the count, then the next position, finally the end
    for (int c = 0; c < n; ++c)
      for (int k = starts[c]; k < starts[c + 1]; ++k)
        if (rows[k] >= c && column_of(to[rows[k]], to[c]) + 2 <= n) ++next[column_of(to[rows[k]], to[c]) + 2];
    for (int c = 2; c <= n; ++c) next[c] += next[c - 1];
    r.resizeNonZeros(a.nonZeros());
    for (int c = 0; c < n; ++c)
      for (int k = starts[c]; k < starts[c + 1]; ++k)
        if (rows[k] >= c) {
          const int i = to[rows[k]], j = to[c], at = next[column_of(i, j) + 1]++;
          r.innerIndexPtr()[at] = is_upper ? std::min(i, j) : std::max(i, j);
          r.valuePtr()[at] = a.valuePtr()[k];
        }
    r.resizeNonZeros(next[n]);
    return r;
  }
};

}  // namespace concino::detail
