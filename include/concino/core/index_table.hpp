// index_table: a hash table of numbers. They stand for values that are stored elsewhere, so that it can be used for
// values of any kind.
#pragma once

#include <concino/core/small_array.hpp>

#include <cstddef>
#include <cstdint>

namespace concino::core {

/// Needs:  numbers below 2^32 - 1, each added once.
class index_table {
  struct slot {
    std::uint32_t hash, number;
  };
  small_array<slot, 64> slots_;  // a power of two, of which at most half have a number; none before the first number
  std::size_t size_ = 0;

  void put(const slot& x) {
    std::size_t i = x.hash & (slots_.size() - 1);
    while (slots_[i].number != none) i = (i + 1) & (slots_.size() - 1);
    slots_[i] = x;
  }
  void enlarge() {
    small_array<slot, 32> old;
    for (const slot& x : slots_)
      if (x.number != none) old.push_back(x);
    const std::size_t n = slots_.empty() ? 64 : 2 * slots_.size();
    slots_.clear();
    slots_.resize(n, {0, none});
    for (const slot& x : old) put(x);
  }

 public:
  static constexpr std::uint32_t none = ~0u;

  /// The hash of a key, or of two parts of it: pass the hash of the first one as `before`.
  static std::uint32_t hash(std::uint64_t key, std::uint32_t before = 0) {
    key = (key + before) * 0x9e3779b97f4a7c15u;
    return static_cast<std::uint32_t>(key >> 32 ^ key);
  }

  std::size_t size() const { return size_; }

  void clear() {
    slots_.clear();
    size_ = 0;
  }

  /// The number that was added with this hash and for which is_wanted(number) holds, or `none`.
  template<class F>
  std::uint32_t find(std::uint32_t hash, const F& is_wanted) const {
    if (slots_.empty()) return none;
    for (std::size_t i = hash & (slots_.size() - 1); slots_[i].number != none; i = (i + 1) & (slots_.size() - 1))
      if (slots_[i].hash == hash && is_wanted(slots_[i].number)) return slots_[i].number;
    return none;
  }

  void add(std::uint32_t hash, std::uint32_t number) {
    if (2 * ++size_ > slots_.size()) enlarge();
    put({hash, number});
  }
};

}  // namespace concino::core
