// A symmetric matrix in an order of elimination that keeps its factor small, and how large that factor is.
#pragma once

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Orders by approximate minimum degree (Amestoy, Davis, Duff 1996) and keeps the order for further matrices of that pattern.
struct elimination_order {
  using permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;
  permutation place;  // of each row
  permutation row;    // at each place

  // Eigen frees a vector before it finds memory for one of another size, and frees it once more where there is none: hence new ones, swapped in.

  /// row_at: the row at each place.
  void keep(const std::vector<int>& row_at) {
    permutation new_row(static_cast<Eigen::Index>(row_at.size())), new_place(new_row.size());
    for (std::size_t i = 0; i < row_at.size(); ++i) {
      new_row.indices()[static_cast<Eigen::Index>(i)] = row_at[i];
      new_place.indices()[row_at[i]] = static_cast<int>(i);
    }
    take(new_row, new_place);
  }

  /// The order depends on where a has entries, in either triangle.
  void find(const Eigen::SparseMatrix<double>& a) {
    Eigen::AMDOrdering<int> order;
    permutation new_row;
    order(a, new_row);
    permutation new_place(new_row.inverse());
    take(new_row, new_place);
  }

  /// The upper triangle of the reordered matrix, from the lower one of a, which is compressed. Loops, because
  /// Eigen's expressions take long to compile.
  Eigen::SparseMatrix<double> operator()(const Eigen::SparseMatrix<double>& a) const {
    const int *const starts = a.outerIndexPtr(), *const rows = a.innerIndexPtr(), *const to = place.indices().data();
    const auto n = static_cast<int>(a.cols());
    Eigen::SparseMatrix<double> upper(n, n);
    int* const next = upper.outerIndexPtr();  // of column c at c + 1, first how many, then where the next goes, in the end where it ends
    for (int c = 0; c < n; ++c)
      for (int k = starts[c]; k < starts[c + 1]; ++k)
        if (rows[k] >= c && std::max(to[rows[k]], to[c]) + 2 <= n) ++next[std::max(to[rows[k]], to[c]) + 2];
    for (int c = 2; c <= n; ++c) next[c] += next[c - 1];
    upper.resizeNonZeros(a.nonZeros());
    for (int c = 0; c < n; ++c)
      for (int k = starts[c]; k < starts[c + 1]; ++k)
        if (rows[k] >= c) {
          const int i = to[rows[k]], j = to[c], at = next[std::max(i, j) + 1]++;
          upper.innerIndexPtr()[at] = std::min(i, j);
          upper.valuePtr()[at] = a.valuePtr()[k];
        }
    upper.resizeNonZeros(next[n]);
    return upper;
  }

 private:
  void take(permutation& new_row, permutation& new_place) {
    row.indices().swap(new_row.indices());
    place.indices().swap(new_place.indices());
  }
};

/// Entries below the diagonal of the factor of a symmetric matrix given by its upper triangle, in its own order; counting ends beyond `most`.
/// Cost:   as many steps as it counts, a small part of a factorisation.
/// Source: Davis, Algorithm 849, 2005.
inline std::int64_t factor_entries(const Eigen::SparseMatrix<double>& upper, std::int64_t most) {
  const auto n = static_cast<std::size_t>(upper.cols());
  std::vector<int> parent(n, -1), seen(n, -1);
  std::int64_t entries = 0;
  for (int c = 0; c < upper.cols() && entries <= most; ++c) {
    seen[static_cast<std::size_t>(c)] = c;
    for (int k = upper.outerIndexPtr()[c]; k < upper.outerIndexPtr()[c + 1]; ++k)
      for (int i = upper.innerIndexPtr()[k]; seen[static_cast<std::size_t>(i)] != c; i = parent[static_cast<std::size_t>(i)]) {
        if (parent[static_cast<std::size_t>(i)] < 0) parent[static_cast<std::size_t>(i)] = c;
        seen[static_cast<std::size_t>(i)] = c;
        ++entries;
      }
  }
  return entries;
}

}  // namespace concino::detail
