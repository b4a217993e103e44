// Reads indices of points and offsets of cells in legacy VTK files, as text or as binary numbers.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/io/detail/vtk/vtk_cursor.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace concino::detail {

class vtk_index_cursor : public vtk_cursor {
 protected:
  static constexpr std::uint32_t max_index = 0x7FFFFFFF;  // indices are written as signed integers

  using vtk_cursor::vtk_cursor;

  void skip_to_value() {
    if (!binary_) skip();
  }

  /// Reads n binary numbers.   Result: the largest.
  std::uint32_t read_ids(vert_id* to, std::size_t n) {
    std::uint32_t largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      std::uint32_t x = 0;
      std::memcpy(&x, at + 4 * i, sizeof x);
      if constexpr (std::endian::native == std::endian::little) x = __builtin_bswap32(x);
      largest = std::max(largest, x);
      to[i] = vert_id{x};
    }
    at += 4 * n;
    return largest;
  }
  /// Errors: parse_error for the first number that is negative, of n + 1 in binary form.
  [[noreturn, gnu::noinline, gnu::cold]] void fail_index(const char* position, std::size_t n) {
    at = position;
    for (std::size_t i = 0; i < n && value<std::int32_t>() >= 0; ++i) position = at;
    at = position;
    reject(position, {"an index of a point"}, {value<std::int32_t>()});
  }
  std::uint32_t next_index_value(const char* position) {
    const auto i = value<std::int32_t>();
    if (i < 0) reject(position, {"an index of a point"}, {i});
    return static_cast<std::uint32_t>(i);
  }

  std::int64_t integer_of(vtk_number type) {
    return with_number_type(type, [&]<class T>(std::type_identity<T>) {
      if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
        const T x = value<T>();
        return std::in_range<std::int64_t>(x) ? static_cast<std::int64_t>(x) : std::int64_t{-1};
      } else {
        return std::int64_t{-1};
      }
    });
  }
};

}  // namespace concino::detail
