// Numbers a few elements 0, 1, 2, ... in the order in which they come.
#pragma once

#include <concino/core/small_array.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::core {

/// The numbers of keys, which are indices of elements.
class local_numbers {
  static constexpr std::size_t longest_scan = 32;

  core::small_array<std::size_t, longest_scan> keys_;
  std::vector<std::uint32_t> slots_;  // a hash table of numbers plus 1, if there are many keys

  std::size_t slot(std::size_t key) const {
    const std::uint64_t h = std::uint64_t{key} * 0x9e3779b97f4a7c15u;
    std::size_t i = static_cast<std::size_t>(h >> 32 ^ h) & (slots_.size() - 1);
    while (slots_[i] != 0 && keys_[slots_[i] - 1] != key) i = (i + 1) & (slots_.size() - 1);
    return i;
  }
  void make_table(std::size_t size) {
    slots_.assign(size, 0);
    for (std::size_t i = 0; i < keys_.size(); ++i) slots_[slot(keys_[i])] = static_cast<std::uint32_t>(i + 1);
  }

 public:
  static constexpr unsigned none = ~0u;

  unsigned size() const { return static_cast<unsigned>(keys_.size()); }

  /// Makes room for n keys.
  void reserve(std::size_t n) {
    if (n <= longest_scan || 2 * n <= slots_.size()) return;
    keys_.reserve(n);
    make_table(std::bit_ceil(std::max<std::size_t>(256, 2 * n)));
  }

  /// The number of a key, or `none`.
  unsigned find(std::size_t key) const {
    if (!slots_.empty()) return slots_[slot(key)] - 1;
    for (unsigned i = 0; i < size(); ++i)
      if (keys_[i] == key) return i;
    return none;
  }
  /// The number of a key. A new key has the number that was size() before.
  unsigned add(std::size_t key) {
    const unsigned found = find(key);
    if (found != none) return found;
    const unsigned number = size();
    keys_.push_back(key);
    if (!slots_.empty() && 2 * keys_.size() <= slots_.size()) slots_[slot(key)] = number + 1;
    else if (keys_.size() > longest_scan) make_table(std::max<std::size_t>(256, 2 * slots_.size()));
    return number;
  }
  std::size_t operator[](unsigned number) const { return keys_[number]; }
  const std::size_t* begin() const { return keys_.begin(); }
  const std::size_t* end() const { return keys_.end(); }
};

}  // namespace concino::core
