// Disjoint sets of indices with union and find (union-find).
#pragma once

#include <concino/core/error.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino {

/// A partition of 0 .. size() - 1 into sets, for components of a graph while edges are added, fans of corners,
/// Kruskal's trees. The root of a set is its smallest index, whatever the order in which sets were united.
/// Needs:  indices below size().
/// Cost:   O(inverse Ackermann function of size()) amortised a call; 4 bytes an index.
/// Errors: invalid_argument for 2^32 indices or more.
/// Source: Tarjan, van Leeuwen 1984 (path halving).
class disjoint_sets {
  std::vector<std::uint32_t> parent_;

  static std::size_t expect_32_bits(std::size_t n) {
    if (n > 0xffffffffu)
      throw invalid_argument("disjoint_sets: there are 2^32 indices or more; 32 bits cannot number them");
    return n;
  }

 public:
  disjoint_sets() = default;
  /// n sets of one index each.
  explicit disjoint_sets(std::size_t n) : parent_(expect_32_bits(n)) {
    for (std::size_t i = 0; i < n; ++i) parent_[i] = static_cast<std::uint32_t>(i);
  }

  std::size_t size() const { return parent_.size(); }

  /// Adds the index size() as a set of its own, and returns it.
  std::size_t add() {
    const std::size_t i = expect_32_bits(parent_.size() + 1) - 1;
    parent_.push_back(static_cast<std::uint32_t>(i));
    return i;
  }

  /// Removes all indices; their memory is kept for later ones.
  void clear() { parent_.clear(); }

  /// The smallest index of the set of i.
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  bool are_united(std::size_t a, std::size_t b) { return root(a) == root(b); }

  /// Unites the sets of a and b; false if they are the same set already.
  bool unite(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return false;
    unite_roots(a, b);
    return true;
  }

  /// The same for inner loops that know both roots; returns the root of the union.
  std::size_t unite_roots(std::size_t a, std::size_t b) {
    if (b < a) {
      parent_[a] = static_cast<std::uint32_t>(b);
      return b;
    }
    parent_[b] = static_cast<std::uint32_t>(a);
    return a;
  }

  /// The number of sets.      Cost: O(size()).
  std::size_t num_sets() const {
    std::size_t n = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) n += parent_[i] == i;
    return n;
  }
};

}  // namespace concino
