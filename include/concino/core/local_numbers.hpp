// Numbers a few elements 0, 1, 2, ... in the order in which they come.
#pragma once

#include <concino/core/index_table.hpp>
#include <concino/core/small_array.hpp>

#include <cstddef>

namespace concino::core {

/// The numbers of keys, which are indices of elements.
class local_numbers {
  static constexpr std::size_t longest_scan = 32;

  small_array<std::size_t, longest_scan> keys_;
  index_table table_;  // the numbers of all keys, if there are many

  void add_to_table(unsigned number) { table_.add(index_table::hash(keys_[number]), number); }

 public:
  static constexpr unsigned none = index_table::none;

  unsigned size() const { return static_cast<unsigned>(keys_.size()); }

  /// The number of a key, or `none`.
  unsigned find(std::size_t key) const {
    if (size() > longest_scan)
      return table_.find(index_table::hash(key), [&](unsigned number) { return keys_[number] == key; });
    for (unsigned i = 0; i < size(); ++i)
      if (keys_[i] == key) return i;
    return none;
  }
  /// The number of a key. A new key has the number that was size() before.
  unsigned add(std::size_t key) {
    if (const unsigned found = find(key); found != none) return found;
    const unsigned number = size();
    keys_.push_back(key);
    if (number == longest_scan)
      for (unsigned i = 0; i < number; ++i) add_to_table(i);
    if (number >= longest_scan) add_to_table(number);
    return number;
  }
  std::size_t operator[](unsigned number) const { return keys_[number]; }
  const std::size_t* begin() const { return keys_.begin(); }
  const std::size_t* end() const { return keys_.end(); }
};

}  // namespace concino::core
