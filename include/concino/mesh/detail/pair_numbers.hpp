// pair_numbers: many pairs of numbers, numbered 0, 1, 2, ... in the order in which each comes first.
#pragma once

#include <concino/core/temporary_array.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace concino::detail {

/// Takes a third of the time of a hash table: there is no search, and no branch that the processor would often predict wrongly.
class pair_numbers {
  struct group {
    std::uint32_t first_index, number;  // of equal pairs
  };
  struct mark {
    std::uint32_t first, group;  // of the last pair with a second entry
  };

  core::temporary_array<std::uint32_t> sorted_;  // indices of pairs by their first entries, in ascending order for each
  core::temporary_array<std::uint32_t> ends_;    // in sorted_, by first entry
  core::temporary_array<mark> marks_;            // by second entry
  core::temporary_array<group> groups_;
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
    for (std::size_t i = 0; i < n; ++i) sorted_[ends[first[i]]++] = static_cast<std::uint32_t>(i);
  }

  /// Replaces first[i] by the group of pair i, for groups in any order.
  std::uint32_t find_groups(std::uint32_t* first, const std::uint32_t* second, std::size_t n, std::size_t second_bound) {
    make_room(marks_, second_bound), make_room(groups_, n);
    std::fill_n(marks_.data(), second_bound, mark{~0u, 0});
    std::uint32_t num_groups = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t i = sorted_[k], a = first[i];
      mark& last = marks_[second[i]];
      const bool is_new = last.first != a;
      const std::uint32_t found = is_new ? num_groups : last.group;
      last = {a, found};
      groups_[num_groups].first_index = i;  // written again unless the pair is new
      num_groups += is_new;
      first[i] = found;
    }
    return num_groups;
  }

 public:
  /// Replaces first[i] by the number of the pair of first[i] and second[i], for all i < n. All entries are below the bounds.
  void number(std::uint32_t* first, const std::uint32_t* second, std::size_t n, std::size_t first_bound, std::size_t second_bound) {
    sort(first, n, first_bound);
    make_room(first_indices_, find_groups(first, second, n, second_bound) + std::size_t{1});
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      group& g = groups_[first[i]];
      const bool is_new = g.first_index == i;
      g.number = is_new ? count : g.number;
      first_indices_[count] = i;  // written again unless the pair is new
      count += is_new;
      first[i] = g.number;
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
