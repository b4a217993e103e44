// Sorts the rows of a heat matrix; see heat_rows.hpp.
#pragma once

#include <concino/fields/detail/heat/heat_rows.hpp>

#include <algorithm>
#include <cstddef>

namespace concino::detail {

CONCINO_INLINE heat_rows::heat_rows(const Eigen::SparseMatrix<double>& lower, std::span<const int> order)
    : begin(order.size() + 1), diagonal(order.size()), mass(order.size()) {
  const std::size_t size = order.size();
  std::vector<int> rank(size);
  for (std::size_t i = 0; i < size; ++i) rank[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  const auto for_each_entry = [&](const auto& f) {
    for (std::size_t c = 0; c < size; ++c)
      for (int k = lower.outerIndexPtr()[c]; k < lower.outerIndexPtr()[c + 1]; ++k) {
        const int r = rank[static_cast<std::size_t>(lower.innerIndexPtr()[k])];
        f(static_cast<std::size_t>(std::max(r, rank[c])), static_cast<std::size_t>(std::min(r, rank[c])),
          lower.valuePtr()[k]);
      }
  };
  for_each_entry([&](std::size_t later, std::size_t earlier, double) { begin[later + 1] += later != earlier; });
  for (std::size_t i = 0; i < size; ++i) begin[i + 1] += begin[i];
  column.resize(static_cast<std::size_t>(begin.back()));
  entry.resize(column.size());
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for_each_entry([&](std::size_t later, std::size_t earlier, double x) {
    mass[later] += x;
    if (later == earlier) {
      diagonal[later] = x;
      return;
    }
    mass[earlier] += x;
    const auto at = static_cast<std::size_t>(next[later]++);
    column[at] = static_cast<int>(earlier);
    entry[at] = -x;
  });
  for (std::size_t i = 0; i < size; ++i) mass[i] = std::max(mass[i], min_mass * diagonal[i]);
}

}  // namespace concino::detail
