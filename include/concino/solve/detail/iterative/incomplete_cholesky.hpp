// An incomplete Cholesky factorisation, the preconditioner of conjugate gradients. Uses loops over flat arrays, because
// Eigen's own takes two seconds to compile.
#pragma once

#include <concino/solve/detail/direct/ordered.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// Numbers the rows of a symmetric matrix, passed as its lower triangle, breadth first. Neighbours are then close in
/// memory, and an incomplete factorisation in this order is as good as any with the same entries. Not bfs_forest:
/// solvers use matrices, not graphs.
inline std::vector<int> breadth_first_order(const Eigen::SparseMatrix<double>& lower) {
  const auto n = static_cast<int>(lower.cols());
  const int *const starts = lower.outerIndexPtr(), *const rows = lower.innerIndexPtr();
  std::vector<int> begin(static_cast<std::size_t>(n) + 2), adjacent;
  for (int c = 0; c < n; ++c)
    for (int k = starts[c]; k < starts[c + 1]; ++k)
      if (rows[k] > c) {
        ++begin[static_cast<std::size_t>(c) + 2];
        ++begin[static_cast<std::size_t>(rows[k]) + 2];
      }
  for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
  adjacent.resize(static_cast<std::size_t>(begin.back()));
  for (int c = 0; c < n; ++c)
    for (int k = starts[c]; k < starts[c + 1]; ++k)
      if (rows[k] > c) {
        adjacent[static_cast<std::size_t>(begin[static_cast<std::size_t>(c) + 1]++)] = rows[k];
        adjacent[static_cast<std::size_t>(begin[static_cast<std::size_t>(rows[k]) + 1]++)] = c;
      }
  std::vector<int> order;
  order.reserve(static_cast<std::size_t>(n));
  std::vector<char> is_known(static_cast<std::size_t>(n));
  for (int seed = 0; seed < n; ++seed) {
    if (is_known[static_cast<std::size_t>(seed)]) continue;
    is_known[static_cast<std::size_t>(seed)] = 1;
    order.push_back(seed);
    for (std::size_t at = order.size() - 1; at < order.size(); ++at) {
      const auto v = static_cast<std::size_t>(order[at]);
      for (int k = begin[v]; k < begin[v + 1]; ++k) {
        const int w = adjacent[static_cast<std::size_t>(k)];
        if (is_known[static_cast<std::size_t>(w)]) continue;
        is_known[static_cast<std::size_t>(w)] = 1;
        order.push_back(w);
      }
    }
  }
  return order;
}

/// L with L L^T near a matrix, with the pattern of its lower triangle. At first fill-in outside the pattern is added to
/// the diagonal, except for a small part. Then the row sums of L L^T are nearly those of the matrix, and the number of
/// steps, n otherwise, is reduced to some root of n. Single small pivots are increased. If there are many, fill-in is
/// dropped instead, and the diagonal is raised until all pivots are positive.
/// Source: Meijerink, van der Vorst 1977; Gustafsson 1978 (sums kept); Manteuffel 1980 (diagonal raised).
class incomplete_cholesky {
  static constexpr int long_column = 256;  // entries; the time for others may grow with the square of their number
  std::vector<double> l_;  // parallel to the entries of the matrix; on the diagonal 1 / l

  /// Subtracts the products of all pairs of entries of column c from the columns after it, in time proportional to the
  /// entries of those. The products outside the pattern, of one entry with many others, are added up first. position:
  /// -1 for each row.
  void eliminate_long(const Eigen::SparseMatrix<double>& a, int c, double keep, std::vector<int>& position) {
    const int *const starts = a.outerIndexPtr(), *const rows = a.innerIndexPtr(), first = starts[c],
                     end = starts[c + 1];
    double* const l = l_.data();
    double sum = 0;
    for (int i = first + 1; i < end; ++i) {
      position[static_cast<std::size_t>(rows[i])] = i;
      sum += l[i];
    }
    for (int j = first + 1; j < end; ++j) {
      const int begin = starts[rows[j]];
      l[begin] -= l[j] * l[j] + keep * l[j] * (sum - l[j]);
      for (int to = begin + 1; to < starts[rows[j] + 1]; ++to) {
        const int i = position[static_cast<std::size_t>(rows[to])];
        if (i < 0) continue;
        const double fill = l[i] * l[j];
        l[to] -= fill;
        l[begin] += keep * fill;  // it was in the sum
        l[starts[rows[to]]] += keep * fill;
      }
    }
    for (int i = first + 1; i < end; ++i) position[static_cast<std::size_t>(rows[i])] = -1;
  }

  bool try_to_factorize(const Eigen::SparseMatrix<double>& a, double raise, double keep) {
    const auto n = static_cast<int>(a.cols());
    const int *const starts = a.outerIndexPtr(), *const rows = a.innerIndexPtr();
    l_.assign(a.valuePtr(), a.valuePtr() + a.nonZeros());
    double* const l = l_.data();
    for (int c = 0; c < n; ++c) l[starts[c]] *= 1 + raise;
    int num_increased = 0;  // number of increased pivots
    std::vector<int> position(static_cast<std::size_t>(n), -1);
    for (int c = 0; c < n; ++c) {
      const int first = starts[c], end = starts[c + 1];
      const double input_pivot = a.valuePtr()[first];
      if (!(l[first] > (keep > 0 ? 0.2 : 1e-3) * input_pivot)) {
        if (keep == 0 || !(l[first] > -input_pivot) || ++num_increased > n / 10) return false;
        l[first] = 0.2 * input_pivot;
      }
      l[first] = 1 / std::sqrt(l[first]);
      for (int k = first + 1; k < end; ++k) l[k] *= l[first];
      if (end - first > long_column) {
        eliminate_long(a, c, keep, position);
        continue;
      }
      for (int j = first + 1; j < end; ++j) {
        const int column = rows[j];
        int to = starts[column];
        const int to_end = starts[column + 1];
        l[to++] -= l[j] * l[j];
        for (int i = j + 1; i < end; ++i) {
          if (to_end - to > long_column)
            to = static_cast<int>(std::lower_bound(rows + to, rows + to_end, rows[i]) - rows);
          while (to < to_end && rows[to] < rows[i]) ++to;
          const double fill = l[i] * l[j];
          if (to < to_end && rows[to] == rows[i]) {
            l[to++] -= fill;
          } else {
            l[starts[column]] -= keep * fill;
            l[starts[rows[i]]] -= keep * fill;
          }
        }
      }
    }
    return true;
  }

 public:
  /// a: a lower triangle with a positive diagonal; each column is sorted, so it begins with its diagonal entry.
  void factorize(const Eigen::SparseMatrix<double>& a) {
    if (try_to_factorize(a, 0, 0.97) || try_to_factorize(a, 0, 0)) return;
    for (double raise = 1e-3; !try_to_factorize(a, raise, 0); raise *= 4) {}
  }

  /// z = (L L^T)^-1 r. a: the factorised matrix.
  void solve(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& r, Eigen::VectorXd& z) const {
    const auto n = static_cast<int>(a.cols());
    const int *const starts = a.outerIndexPtr(), *const rows = a.innerIndexPtr();
    const double* const l = l_.data();
    z = r;
    double* const x = z.data();
    for (int c = 0; c < n; ++c) {
      const double xc = x[c] *= l[starts[c]];
      for (int k = starts[c] + 1; k < starts[c + 1]; ++k) x[rows[k]] -= l[k] * xc;
    }
    for (int c = n - 1; c >= 0; --c) {
      double xc = x[c];
      for (int k = starts[c] + 1; k < starts[c + 1]; ++k) xc -= l[k] * x[rows[k]];
      x[c] = xc * l[starts[c]];
    }
  }
};

}  // namespace concino::detail
