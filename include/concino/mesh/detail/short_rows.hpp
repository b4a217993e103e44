// Searches and changes of short rows of numbers without branches on their length, which processors would often predict wrongly.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace concino::detail {

/// Values that these functions compare and copy as numbers of 32 bits.
template<class T>
inline constexpr bool is_short_value = sizeof(T) == sizeof(std::uint32_t) && std::is_trivially_copyable_v<T>;

/// Eight values in the registers of vectors; compilers do not put them there on their own.
using eight_numbers = std::uint32_t __attribute__((vector_size(32)));
using eight_comparisons = std::int32_t __attribute__((vector_size(32)));

template<class T>
  requires is_short_value<T>
[[gnu::always_inline]] inline void read_eight(const T* row, eight_numbers& to) { std::memcpy(&to, static_cast<const void*>(row), sizeof to); }

/// Eight comparisons as eight bits.
[[gnu::always_inline]] inline std::uint32_t bits_of_eight(const eight_comparisons& is_true) {
  constexpr eight_comparisons bits = {1, 2, 4, 8, 16, 32, 64, 128};
  const eight_comparisons found = is_true & bits;
  auto four = __builtin_shufflevector(found, found, 0, 1, 2, 3) | __builtin_shufflevector(found, found, 4, 5, 6, 7);
  four |= __builtin_shufflevector(four, four, 2, 3, 0, 1);
  return static_cast<std::uint32_t>(four[0] | four[1]);
}
#ifdef __SSE__
/// The same by instructions of these processors, which compilers do not find.
[[gnu::always_inline]] inline std::uint32_t bits_of_eight_by_signs(const eight_comparisons& is_true) {
  using four_floats = float __attribute__((vector_size(16)));
  const auto bits_of_four = [](const auto& four) { return static_cast<std::uint32_t>(__builtin_ia32_movmskps(std::bit_cast<four_floats>(four))); };
  return bits_of_four(__builtin_shufflevector(is_true, is_true, 0, 1, 2, 3)) | bits_of_four(__builtin_shufflevector(is_true, is_true, 4, 5, 6, 7)) << 4;
}
#endif

/// The first k < 8 with row[k] == value, or 8. Eight values at `row` are readable.
template<class T>
  requires is_short_value<T>
[[gnu::always_inline]] inline std::uint32_t find_in_eight(const T* row, const T& value) {
  eight_numbers now;
  read_eight(row, now);
  const eight_comparisons is_equal = now == std::bit_cast<std::uint32_t>(value);
#ifdef __SSE__
  return static_cast<std::uint32_t>(std::countr_zero(bits_of_eight_by_signs(is_equal) | 1u << 8));
#else
  return static_cast<std::uint32_t>(std::countr_zero(bits_of_eight(is_equal) | 1u << 8));
#endif
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

// Rows of any length, of which most are short. `readable` values can be read at their beginning, though they may be those of other rows.

/// The place of a value in a row that has it.
template<class T>
[[gnu::always_inline]] inline std::uint32_t position_in_row(const T* row, std::size_t readable, const T& value) {
  std::uint32_t k = 0;
  if (readable >= 8) [[likely]] {
    k = find_in_eight(row, value);
    if (k < 8) [[likely]] return k;
  }
  while (!(row[k] == value)) ++k;
  return k;
}

/// The first place of a value in a row of n values, or n.
template<class T>
[[gnu::always_inline]] inline std::uint32_t find_in_short_row(const T* row, std::uint32_t n, std::size_t readable, const T& value) {
  std::uint32_t k = 0;
  if (readable >= 8) [[likely]] {
    k = find_in_eight(row, value);
    if (k < 8 || n <= 8) [[likely]] return std::min(k, n);
  }
  while (k < n && !(row[k] == value)) ++k;
  return k;
}

/// Removes the k-th of n values; the others keep their order.
template<class T>
[[gnu::always_inline]] inline void close_gap_in_row(T* row, std::uint32_t k, std::uint32_t n, std::size_t readable) {
  if (n <= 8 && readable >= 8) [[likely]] return close_gap_in_eight(row, k, n);
  std::copy(row + k + 1, row + n, row + k);
}

}  // namespace concino::detail
