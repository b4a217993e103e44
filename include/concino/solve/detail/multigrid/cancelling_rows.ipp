// Rows whose entries cancel, smoothed by products of Eigen; see cancelling_rows.hpp.
#pragma once

#include <concino/solve/detail/multigrid/cancelling_rows.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace concino::detail {

CONCINO_INLINE std::vector<char> cancelling_rows::find(const Eigen::SparseMatrix<double>& a) {
  const auto n = static_cast<std::size_t>(a.cols());
  std::vector<double> positive(n);
  for (std::size_t c = 0; c < n; ++c)
    for (int k = a.outerIndexPtr()[c] + 1; k < a.outerIndexPtr()[c + 1]; ++k) {
      positive[c] += std::max(a.valuePtr()[k], 0.0);
      positive[static_cast<std::size_t>(a.innerIndexPtr()[k])] += std::max(a.valuePtr()[k], 0.0);
    }
  std::vector<char> r(n);
  for (std::size_t i = 0; i < n; ++i) r[i] = positive[i] > share * a.valuePtr()[a.outerIndexPtr()[i]];
  return r;
}

CONCINO_INLINE bool cancelling_rows::pay_for(const Eigen::SparseMatrix<double>& a) {
  constexpr double fewest = 5.5, most = 10;  // entries of a column of the lower triangle, on average: 7 on Voronoi
                                             // polygons, 5 on quads, 13 on hexes
  constexpr double least = 0.8;              // of all rows: 0.9 on polygons stretched 1 : 100, 0.5 on uniform ones
  const auto n = static_cast<double>(a.cols()), entries = static_cast<double>(a.nonZeros());
  if (entries < fewest * n || entries > most * n) return false;
  const std::vector<char> rows = find(a);
  return static_cast<double>(std::count(rows.begin(), rows.end(), 1)) > least * n;
}

CONCINO_INLINE cancelling_rows::cancelling_rows(const Eigen::SparseMatrix<double>& a) : contains_(find(a)) {
  step_ = a.selfadjointView<Eigen::Lower>();
  for (int i = 0; i < step_.rows(); ++i) {
    char& is_contained = contains_[static_cast<std::size_t>(i)];
    const int first = step_.outerIndexPtr()[i], end = step_.outerIndexPtr()[i + 1];
    if (end - first - 1 > max_per_row) is_contained = 0;  // so that the coarse matrix stays sparse
    const double factor = is_contained ? -damping / a.valuePtr()[a.outerIndexPtr()[i]] : 0;
    for (int k = first; k < end; ++k)
      step_.valuePtr()[k] =
          step_.innerIndexPtr()[k] == i ? (is_contained ? 1 - damping : 1) : factor * step_.valuePtr()[k];
  }
  step_.prune([&](Eigen::Index i, Eigen::Index j, double) { return i == j || contains_[static_cast<std::size_t>(i)]; });
}

/// Appends the large entries of a row, scaled so that they have the sum of all.
CONCINO_INLINE void append_large(std::span<const int> columns, std::span<const double> row, double small,
                                 prolongation& p) {
  std::vector<double> weights;
  double largest = 0, all = 0, kept = 0;
  for (const double x : row) {
    largest = std::max(largest, std::abs(x));
    all += x;
  }
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (!(std::abs(row[k]) > small * largest)) continue;
    p.column.push_back(columns[k]);
    weights.push_back(row[k]);
    kept += row[k];
  }
  if (kept > 0 && all >= kept / 2 && all <= 2 * kept)  // sums that are nearly 0 stay as they are
    for (double& w : weights) w *= all / kept;
  append_rounded(weights, p.weight);
}

CONCINO_INLINE prolongation cancelling_rows::smooth_once(const prolongation& p, std::size_t max_entries) const {
  using by_rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  const Eigen::Map<const Eigen::SparseMatrix<float, Eigen::RowMajor>> weights(
      step_.rows(), p.columns, static_cast<Eigen::Index>(p.column.size()), p.begin.data(), p.column.data(),
      p.weight.data());
  Eigen::SparseMatrix<double> columns;
  columns = weights.cast<double>();
  by_rows before, product;
  before = columns;  // with sorted rows
  product = step_ * before;
  prolongation r;
  r.begin.reserve(p.begin.size());
  r.begin.push_back(0);
  for (std::size_t i = 0; i < contains_.size(); ++i) {
    const auto first = static_cast<std::size_t>(product.outerIndexPtr()[i]),
               count = static_cast<std::size_t>(product.outerIndexPtr()[i + 1]) - first;
    const std::span<const int> column(product.innerIndexPtr() + first, count);
    const std::span<const double> row(product.valuePtr() + first, count);
    if (contains_[i]) {
      append_large(column, row, small_weight, r);
    } else {
      r.column.insert(r.column.end(), column.begin(), column.end());
      for (const double w : row) r.weight.push_back(static_cast<float>(w));
    }
    if (r.column.size() > max_entries) return {};
    r.begin.push_back(static_cast<int>(r.column.size()));
  }
  r.columns = p.columns;
  return r;
}

}  // namespace concino::detail
