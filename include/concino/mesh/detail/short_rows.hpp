// Searches and changes of short rows of numbers without branches on their length, which processors would often predict wrongly.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace concino::detail {

/// Values that these functions compare and copy as numbers of 32 bits.
template<class T>
inline constexpr bool is_short_value = sizeof(T) == sizeof(std::uint32_t) && std::is_trivially_copyable_v<T>;

/// Eight values in the registers of vectors; compilers do not put them there on their own.
using eight_numbers = std::uint32_t __attribute__((vector_size(32)));

template<class T>
  requires is_short_value<T>
[[gnu::always_inline]] inline void read_eight(const T* row, eight_numbers& to) { std::memcpy(&to, static_cast<const void*>(row), sizeof to); }

/// The first k < 8 with row[k] == value, or 8. Eight values at `row` are readable.
template<class T>
  requires is_short_value<T>
[[gnu::always_inline]] inline std::uint32_t find_in_eight(const T* row, const T& value) {
  constexpr eight_numbers bits = {1, 2, 4, 8, 16, 32, 64, 128};
  eight_numbers now;
  read_eight(row, now);
  const eight_numbers found = now == std::bit_cast<std::uint32_t>(value) ? bits : eight_numbers{};
  auto four = __builtin_shufflevector(found, found, 0, 1, 2, 3) | __builtin_shufflevector(found, found, 4, 5, 6, 7);
  four |= __builtin_shufflevector(four, four, 2, 3, 0, 1);
  return static_cast<std::uint32_t>(std::countr_zero(static_cast<std::uint32_t>(four[0] | four[1]) | 1u << 8));
}

/// Removes the k-th of n <= 8 values; the others keep their order. Eight values at `row` are readable; those behind the n remain as they are.
template<class T>
  requires is_short_value<T>
[[gnu::always_inline]] inline void close_gap_in_eight(T* row, std::uint32_t k, std::uint32_t n) {
  constexpr eight_numbers place = {0, 1, 2, 3, 4, 5, 6, 7};
  eight_numbers now;
  read_eight(row, now);
  const eight_numbers next = __builtin_shufflevector(now, now, 1, 2, 3, 4, 5, 6, 7, 7);
  now = place - k < n - 1 - k ? next : now;  // places before k wrap around
  std::memcpy(static_cast<void*>(row), &now, sizeof now);
}

}  // namespace concino::detail
