// row_lookup: finds the position of a value in a row, by linear search in short rows and by bisection in long ones.
#pragma once

#include <concino/mesh/detail/rows/jagged_array.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The positions in the long rows of a table, sorted by value. It uses memory for long rows only. It may be out of
/// date: a row that was added later, or whose length has changed, is searched linearly.
class row_lookup {
  std::vector<std::uint32_t> rows_;     // the long rows, ascending
  std::vector<std::uint32_t> first_;    // where the positions of each begin in order_, and the end
  std::vector<std::uint32_t> order_;

 public:
  static constexpr std::uint32_t longest_scan = 64;

  row_lookup() = default;
  template<class Rows>
  explicit row_lookup(const Rows& all) {
    std::vector<std::uint64_t> sorted;  // the value and its position
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::uint32_t n = all.length(i);
      if (n <= longest_scan) continue;
      const auto row = all[i];
      sorted.clear();
      for (std::uint32_t k = 0; k < n; ++k) sorted.push_back(std::uint64_t{row[k].raw()} << 32 | k);
      std::sort(sorted.data(), sorted.data() + n);
      rows_.push_back(static_cast<std::uint32_t>(i));
      first_.push_back(static_cast<std::uint32_t>(order_.size()));
      for (const std::uint64_t x : sorted) order_.push_back(static_cast<std::uint32_t>(x));
    }
    first_.push_back(static_cast<std::uint32_t>(order_.size()));
    shrink_if_wasteful(order_);
  }

  /// The position of a value in a row of more than `longest_scan` values, in which it occurs at most once; the length
  /// of the row if it does not occur.
  template<class Row, class T>
  std::uint32_t find(std::uint32_t i, const Row& row, const T& value) const {
    const auto n = static_cast<std::uint32_t>(row.size());
    const auto known = std::lower_bound(rows_.begin(), rows_.end(), i);
    if (known != rows_.end() && *known == i) {
      const std::uint32_t* const first = order_.data() + first_[static_cast<std::size_t>(known - rows_.begin())];
      const std::uint32_t* const last = order_.data() + first_[static_cast<std::size_t>(known - rows_.begin()) + 1];
      if (static_cast<std::uint32_t>(last - first) == n) {
        const std::uint32_t* const at =
            std::lower_bound(first, last, value, [&](std::uint32_t k, const T& x) { return row[k] < x; });
        if (at != last && row[*at] == value) return *at;
      }
    }
    std::uint32_t k = 0;
    while (k < n && row[k] != value) ++k;
    return k;
  }
};

}  // namespace concino::detail
