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

/// The first k < 8 with row[k] == value, or 8. Eight values at `row` are readable.
template<class T>
  requires is_short_value<T>
std::uint32_t find_in_eight(const T* row, const T& value) {
  std::uint32_t found = 1u << 8;
  for (std::uint32_t k = 0; k < 8; ++k) found |= static_cast<std::uint32_t>(row[k] == value) << k;
  return static_cast<std::uint32_t>(std::countr_zero(found));
}

/// Removes the k-th of n <= 8 values; the others keep their order. Eight values at `row` are readable; those behind the n remain as they are.
template<class T>
  requires is_short_value<T>
void close_gap_in_eight(T* row, std::uint32_t k, std::uint32_t n) {
  std::uint32_t now[8], next[8];
  std::memcpy(now, static_cast<const void*>(row), sizeof now);
  std::memcpy(next, now + 1, sizeof next - sizeof *next);
  next[7] = now[7];
  for (std::uint32_t i = 0; i < 8; ++i) now[i] = i >= k && i + 1 < n ? next[i] : now[i];
  std::memcpy(static_cast<void*>(row), now, sizeof now);
}

}  // namespace concino::detail
