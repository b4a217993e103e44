// Sets of indices that are united one after another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// 0 .. n-1, each alone at first; n < 2^32. The root of a set is its least index; paths are halved as they are walked.
/// Source: Tarjan, van Leeuwen 1984.
class disjoint_sets {
  std::vector<std::uint32_t> parent_;

 public:
  explicit disjoint_sets(std::size_t n) : parent_(n) {
    for (std::size_t i = 0; i < n; ++i) parent_[i] = static_cast<std::uint32_t>(i);
  }

  std::size_t root(std::size_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  /// Unites two sets given by their roots; the root of both.
  std::size_t unite_roots(std::size_t a, std::size_t b) {
    if (b < a) {
      parent_[a] = static_cast<std::uint32_t>(b);
      return b;
    }
    parent_[b] = static_cast<std::uint32_t>(a);
    return a;
  }

  /// Unites the sets of a and b; false if they are one already.
  bool unite(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return false;
    unite_roots(a, b);
    return true;
  }
};

}  // namespace concino::detail
