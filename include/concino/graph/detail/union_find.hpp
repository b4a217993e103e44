// Which of n things belong together, as pairs are joined one after another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace concino::detail {

/// Sets over 0 .. n-1, each at first of one thing. Needs n < 2^32. Almost constant time per call.
/// Source: Tarjan, van Leeuwen 1984: linking by size, paths halved on the way.
class union_find {
  std::vector<std::uint32_t> parent_, size_;

 public:
  explicit union_find(std::size_t n) : parent_(n), size_(n, 1) { std::iota(parent_.begin(), parent_.end(), std::uint32_t{0}); }

  /// The thing that stands for the set of x.
  std::size_t find(std::size_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  /// Joins the sets of a and b; false if they were one already.
  bool join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (size_[a] < size_[b]) std::swap(a, b);
    parent_[b] = static_cast<std::uint32_t>(a);
    size_[a] += size_[b];
    return true;
  }
};

}  // namespace concino::detail
