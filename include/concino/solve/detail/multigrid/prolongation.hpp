// Interpolation from the unknowns of a coarser matrix to those of a finer one, and its transpose.
#pragma once

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// Interpolation from a coarser matrix: value i is the sum of weight[k] times the coarse value column[k], for k in
/// [begin[i], begin[i + 1]).
struct prolongation {
  std::vector<int> begin, column;
  std::vector<float> weight;
  int columns = 0;
};

/// The same by columns: row[k] has weight[k] for coarse value c, for k in [begin[c], begin[c + 1]). Cycles use it,
/// since columns have more entries than rows.
struct restriction {
  std::vector<int> begin, row;
  std::vector<float> weight;

  restriction() = default;
  explicit restriction(const prolongation& p)
      : begin(static_cast<std::size_t>(p.columns) + 2), row(p.column.size()), weight(p.column.size()) {
    for (const int c : p.column) ++begin[static_cast<std::size_t>(c) + 2];
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    for (std::size_t i = 0; i + 1 < p.begin.size(); ++i)
      for (auto k = static_cast<std::size_t>(p.begin[i]); k < static_cast<std::size_t>(p.begin[i + 1]); ++k) {
        const auto to = static_cast<std::size_t>(begin[static_cast<std::size_t>(p.column[k]) + 1]++);
        row[to] = static_cast<int>(i);
        weight[to] = p.weight[k];
      }
    begin.pop_back();
  }

  int size() const { return static_cast<int>(begin.size()) - 1; }
};

/// Rounds weights to multiples of 2^-22, so that those with the sum 1 still have exactly that sum: constants are
/// interpolated without rounding errors.
inline void append_rounded(const std::vector<double>& weights, std::vector<float>& rounded) {
  constexpr double unit = 0x1p-22;
  double sum = 0, others = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    sum += weights[k];
    if (k > 0) others += std::nearbyint(weights[k] / unit);
  }
  for (std::size_t k = 0; k < weights.size(); ++k)
    rounded.push_back(
        static_cast<float>((k > 0 ? std::nearbyint(weights[k] / unit) : std::nearbyint(sum / unit) - others) * unit));
}

}  // namespace concino::detail
