// The segments that a sweep line meets, in order: a balanced search tree in flat arrays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Trees of numbers, ordered by position, with split and merge. A number is in at most one tree.
/// Source: Seidel and Aragon 1996, "Randomized search trees"; priorities are hashes of the numbers.
class segment_status {
  std::vector<std::uint32_t> low_, high_;  // children

  static std::uint32_t priority(std::uint32_t i) {
    i = (i ^ (i >> 16)) * 0x45d9f3bu;
    i = (i ^ (i >> 16)) * 0x45d9f3bu;
    return i ^ (i >> 16);
  }

 public:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  explicit segment_status(std::size_t n) : low_(n, none), high_(n, none) {}

  /// Moves the numbers for which is_below is true, which come first in the tree, to `below`, and the others to `above`.
  template<class IsBelow>
  void split(std::uint32_t tree, const IsBelow& is_below, std::uint32_t& below, std::uint32_t& above) {
    std::uint32_t *to_below = &below, *to_above = &above;
    while (tree != none)
      if (is_below(tree)) {
        *to_below = tree;
        to_below = &high_[tree];
        tree = *to_below;
      } else {
        *to_above = tree;
        to_above = &low_[tree];
        tree = *to_above;
      }
    *to_below = *to_above = none;
  }

  /// The numbers of `below`, then those of `above`.
  std::uint32_t merge(std::uint32_t below, std::uint32_t above) {
    std::uint32_t tree = none;
    std::uint32_t* to = &tree;
    while (below != none && above != none)
      if (priority(below) > priority(above)) {
        *to = below;
        to = &high_[below];
        below = *to;
      } else {
        *to = above;
        to = &low_[above];
        above = *to;
      }
    *to = below != none ? below : above;
    return tree;
  }

  /// The first and the last number; none of an empty tree.
  std::uint32_t first(std::uint32_t tree) const {
    while (tree != none && low_[tree] != none) tree = low_[tree];
    return tree;
  }
  std::uint32_t last(std::uint32_t tree) const {
    while (tree != none && high_[tree] != none) tree = high_[tree];
    return tree;
  }

  /// The numbers of the tree, in any order.
  void list(std::uint32_t tree, std::vector<std::uint32_t>& numbers) const {
    numbers.clear();
    if (tree != none) numbers.push_back(tree);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      for (const std::uint32_t child : {low_[numbers[i]], high_[numbers[i]]})
        if (child != none) numbers.push_back(child);
  }
  /// Makes a tree of one number of it.
  std::uint32_t single(std::uint32_t number) {
    low_[number] = high_[number] = none;
    return number;
  }
};

}  // namespace concino::detail
