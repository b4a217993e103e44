// Lists of numbers by a key of each, in two arrays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// The numbers 0 .. count - 1 in lists by key, each list ascending.
class grouped_numbers {
  std::vector<std::uint32_t> first_, numbers_;

 public:
  /// key_of(number): below `keys`.
  template<class KeyOf>
  grouped_numbers(std::size_t keys, std::size_t count, const KeyOf& key_of) : first_(keys + 1), numbers_(count) {
    for (std::size_t i = 0; i < count; ++i) ++first_[key_of(i)];
    std::uint32_t sum = 0;
    for (std::uint32_t& f : first_) sum += f, f = sum;
    for (std::size_t i = count; i-- > 0;) numbers_[--first_[key_of(i)]] = static_cast<std::uint32_t>(i);
  }
  std::span<const std::uint32_t> operator[](std::size_t key) const {
    return {numbers_.data() + first_[key], numbers_.data() + first_[key + 1]};
  }
};

}  // namespace concino::detail
