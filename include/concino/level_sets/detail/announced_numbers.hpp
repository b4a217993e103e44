// Numbers some of many indices in the order in which they come, in little memory: two bits for each index, and a number for each one that comes.
#pragma once

#include <concino/core/block_allocator.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace concino::detail {

/// First the indices that will come are announced, in any order and repeatedly.
class announced_numbers {
  struct word {
    std::uint64_t bits = 0;    // those of the announced indices
    std::uint32_t before = 0;  // how many smaller indices are announced
  };

  template<class T> using array = std::vector<T, core::block_allocator<T>>;

  array<word> announced_;        // 64 indices each
  array<std::uint32_t> number_;  // of the announced ones, by index

 public:
  /// For indices below `bound`, in a block of memory if there is one.
  explicit announced_numbers(std::size_t bound, const std::shared_ptr<core::memory_block>& block = nullptr)
      : announced_((bound + 63) / 64, core::block_allocator<word>(block)), number_(core::block_allocator<std::uint32_t>(block)) {}
  /// The bytes of a block that so many announced indices take.
  static std::size_t bytes_for(std::size_t bound, std::size_t announced) { return (bound / 64 + 2) * sizeof(word) + (announced + 1) * sizeof(std::uint32_t); }

  void announce(std::size_t index) { announced_[index / 64].bits |= std::uint64_t{1} << index % 64; }
  /// Counts the announced indices. It must follow after all were announced.
  std::uint32_t count() {
    std::uint32_t n = 0;
    for (word& w : announced_) {
      w.before = n;
      n += static_cast<std::uint32_t>(std::popcount(w.bits));
    }
    number_.assign(n, ~0u);
    return n;
  }

  /// The number of an announced index. The first time it is `next`, which is to be the number of those that came before.
  std::uint32_t add(std::size_t index, std::size_t next) {
    const word& w = announced_[index / 64];
    std::uint32_t& number = number_[w.before + static_cast<std::uint32_t>(std::popcount(w.bits & ((std::uint64_t{1} << index % 64) - 1)))];
    if (number == ~0u) number = static_cast<std::uint32_t>(next);
    return number;
  }
};

}  // namespace concino::detail
