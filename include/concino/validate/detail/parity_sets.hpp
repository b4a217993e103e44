// Disjoint sets with parity: can all polys be oriented consistently?
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace concino::detail {

/// Disjoint sets over 0 .. n-1, initially of one element each. Each element is turned or not, relative to the root of
/// its set.
/// Source: Tarjan 1975, linking by size, with path compression.
class parity_sets {
  std::vector<std::uint32_t> parent_, size_;
  std::vector<std::uint8_t> turned_;  // relative to the parent
  std::vector<std::uint32_t> path_;

 public:
  explicit parity_sets(std::size_t n) : parent_(n), size_(n, 1), turned_(n) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }

  /// The root of x, and whether x is turned relative to it.
  std::pair<std::uint32_t, bool> find(std::uint32_t x) {
    path_.clear();
    while (parent_[x] != x) {
      path_.push_back(x);
      x = parent_[x];
    }
    bool turned = false;
    for (std::size_t i = path_.size(); i-- > 0;) {
      turned = turned != (turned_[path_[i]] != 0);
      turned_[path_[i]] = turned;
      parent_[path_[i]] = x;
    }
    return {x, turned};
  }

  /// Joins the sets of a and b; `turned` says whether b is turned relative to a.
  /// Result: false if they were in one set already and that contradicts `turned`.
  bool join(std::uint32_t a, std::uint32_t b, bool turned) {
    auto [root_a, turned_a] = find(a);
    auto [root_b, turned_b] = find(b);
    const bool roots_differ = (turned_a != turned_b) != turned;
    if (root_a == root_b) return !roots_differ;
    if (size_[root_a] < size_[root_b]) std::swap(root_a, root_b);
    parent_[root_b] = root_a;
    turned_[root_b] = roots_differ;
    size_[root_a] += size_[root_b];
    return true;
  }
};

}  // namespace concino::detail
