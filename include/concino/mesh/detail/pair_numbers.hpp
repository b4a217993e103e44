// pair_numbers: many pairs of numbers, numbered 0, 1, 2, ... in the order in which each comes first.
#pragma once

#include <concino/core/temporary_array.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace concino::detail {

/// Takes about half the time of a hash table: there is no search, and no branch that the processor would often predict wrongly. Two numbers that are read
/// together are one, since compilers make a branch where only one of both is always needed.
class pair_numbers {
  core::temporary_array<std::uint32_t> sorted_;  // indices of pairs by their first entries, in ascending order for each
  core::temporary_array<std::uint32_t> ends_;    // in sorted_, by first entry
  core::temporary_array<std::uint64_t> last_;    // by second entry: the first entry and, in the upper half, the group of the last pair with it
  core::temporary_array<std::uint64_t> groups_;  // of equal pairs: the index of the first one and, in the upper half, their number
  core::temporary_array<std::uint32_t> first_indices_;
  std::size_t size_ = 0;

  template<class T>
  static void make_room(core::temporary_array<T>& a, std::size_t n) {
    if (a.capacity() < n) a = core::temporary_array<T>(n);
  }

  void sort(const std::uint32_t* first, std::size_t n, std::size_t first_bound) {
    make_room(sorted_, n), make_room(ends_, first_bound + 1);
    std::uint32_t* const ends = ends_.data();
    std::fill_n(ends, first_bound + 1, 0u);
    for (std::size_t i = 0; i < n; ++i) ++ends[first[i]];
    std::uint32_t begin = 0;
    for (std::size_t a = 0; a < first_bound; ++a) {
      const std::uint32_t count = ends[a];
      ends[a] = begin;
      begin += count;
    }
    std::uint32_t* const sorted = sorted_.data();
    for (std::size_t i = 0; i < n; ++i) sorted[ends[first[i]]++] = static_cast<std::uint32_t>(i);
  }

  /// Replaces first[i] by the group of pair i, for groups in any order.
  std::size_t find_groups(std::uint32_t* first, const std::uint32_t* second, std::size_t n, std::size_t second_bound) {
    make_room(last_, second_bound), make_room(groups_, n);
    std::fill_n(last_.data(), second_bound, std::uint64_t{~0u});
    const std::uint32_t* const sorted = sorted_.data();
    std::uint64_t *const last = last_.data(), *const groups = groups_.data(), num_groups = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t i = sorted[k], a = first[i];
      std::uint64_t& known = last[second[i]];
      const bool is_new = static_cast<std::uint32_t>(known) != a;
      const std::uint64_t found = is_new ? num_groups : known >> 32;
      known = found << 32 | a;
      groups[num_groups] = i;  // written again unless the pair is new
      num_groups += is_new;
      first[i] = static_cast<std::uint32_t>(found);
    }
    return num_groups;
  }

 public:
  /// Replaces first[i] by the number of the pair of first[i] and second[i], for all i < n. All entries are below the bounds.
  void number(std::uint32_t* first, const std::uint32_t* second, std::size_t n, std::size_t first_bound, std::size_t second_bound) {
    sort(first, n, first_bound);
    make_room(first_indices_, find_groups(first, second, n, second_bound) + 1);
    std::uint64_t *const groups = groups_.data(), count = 0;
    std::uint32_t* const first_indices = first_indices_.data();
    for (std::uint32_t i = 0; i < n; ++i) {
      std::uint64_t& known = groups[first[i]];
      const bool is_new = static_cast<std::uint32_t>(known) == i;
      const std::uint64_t number = is_new ? count : known >> 32;
      known = number << 32 | static_cast<std::uint32_t>(known);
      first_indices[count] = i;  // written again unless the pair is new
      count += is_new;
      first[i] = static_cast<std::uint32_t>(number);
    }
    size_ = count;
  }

  /// How many different pairs there were.
  std::size_t size() const { return size_; }
  /// The indices of the first pair with each number.
  const std::uint32_t* begin() const { return first_indices_.data(); }
  const std::uint32_t* end() const { return first_indices_.data() + size_; }
};

}  // namespace concino::detail
