// Reads numbers of types that are known when the program runs: as text, or as binary numbers of either byte order.
#pragma once

#include <concino/io/detail/vtk/vtk_numbers.hpp>
#include <concino/io/text_cursor.hpp>

#include <bit>
#include <charconv>
#include <cstring>
#include <limits>

namespace concino::detail {

/// A position in a file with numbers of several types. In binary files errors name the byte, and the line before the
/// numbers, as there are no lines after it.
class typed_number_cursor : public token_cursor {
 protected:
  bool binary_ = false;
  bool swapped_ = std::endian::native == std::endian::little;  // the bytes of each number are in the other order
  const char* binary_line_ = nullptr;

  using token_cursor::token_cursor;

  [[noreturn, gnu::noinline, gnu::cold]] void reject(const char* position, core::message expected,
                                                     core::message found) const {
    if (!binary_) fail(position, expected, found);
    fail(binary_line_, expected, {core::joined(found), " at byte ", static_cast<std::uint64_t>(position - begin())});
  }
  [[noreturn, gnu::noinline, gnu::cold]] void reject(const char* position, core::message expected) const {
    reject(position, expected, {found_at(position)});
  }

  /// Whether the rest of the file can hold n numbers. Errors: parse_error if not.
  void require_room(const char* position, std::uint64_t n, vtk_number type) const {
    const std::uint64_t room = left() + (binary_ ? 0 : 1), size = binary_ ? vtk_names_of(type).size : 2;
    const std::uint64_t most = type == vtk_number::bit && binary_ ? (room < max_count ? 8 * room : room) : room / size;
    if (n > most)
      reject(position, {"a count that fits into the file"},
             {n, " ", vtk_names_of(type).legacy, " numbers, and ", left(), " bytes"});
  }

  /// Reads an integer of so many bytes as text. Result: modulo 2^64. One function for all types, which compiles faster
  /// than ten.
  std::uint64_t next_integer(bool is_signed, std::size_t size) {
    skip();
    std::int64_t i = 0;
    const char* p = parse_integer(at, end(), i);
    auto x = static_cast<std::uint64_t>(i);
    if (!p || !ends_token(p, 0)) {  // 19 digits and more
      const auto r = is_signed ? std::from_chars(at, end(), i) : std::from_chars(at, end(), x);
      p = r.ec == std::errc() && ends_token(r.ptr, 0) ? r.ptr : nullptr;
      if (is_signed) x = static_cast<std::uint64_t>(i);
    } else if (!is_signed && i < 0) {
      p = nullptr;
    }
    const std::size_t bits = 8 * size;
    const bool fits = is_signed ? static_cast<std::int64_t>(x) >> (bits - 1) == static_cast<std::int64_t>(x) >> 63
                                : bits == 64 || x >> bits == 0;
    if (!p || !fits) reject(at, {"an integer of type ", is_signed ? "int" : "unsigned int", bits});
    at = p;
    return x;
  }
  double next_real() {
    skip();
    double x = 0;
    const char* const p = parse_real(at, end(), x);
    if (!p || !ends_token(p, 0)) reject(at, {"a number"});
    at = p;
    return x;
  }
  template<class T>
  T next_value() {
    if constexpr (std::is_floating_point_v<T>) return static_cast<T>(next_real());
    else return static_cast<T>(next_integer(std::is_signed_v<T>, sizeof(T)));
  }

  /// Reads one number. Needs: as read_values.
  template<class T>
  T value() {
    if (!binary_) {
      report_progress();
      return next_value<T>();
    }
    T x;
    std::memcpy(&x, at, sizeof x);
    if (swapped_) swap_bytes(&x, 1, sizeof x);
    at += sizeof x;
    return x;
  }

  /// Reads n numbers into memory. Needs: at the first number, and require_room() for this type.
  template<class T>
  void read_values(T* to, std::size_t n) {
    if (binary_) {
      if (n) std::memcpy(to, at, n * sizeof(T));
      if (swapped_) swap_bytes(to, n, sizeof(T));
      at += n * sizeof(T);
      report_progress();
    } else {
      for (std::size_t i = 0; i < n; ++i) {
        to[i] = next_value<T>();
        report_progress();
      }
    }
  }
  /// The same with any type of numbers but bits.
  void read_values_of(vtk_number type, void* to, std::size_t n) {
    if (type == vtk_number::float64) return read_values(static_cast<double*>(to), n);
    const std::size_t size = vtk_names_of(type).size;
    auto* p = static_cast<unsigned char*>(to);
    if (binary_) {
      if (n) std::memcpy(p, at, n * size);
      if (swapped_) swap_bytes(p, n, size);
      at += n * size;
      return report_progress();
    }
    for (; n > 0; --n, p += size) {
      if (type == vtk_number::float32) {
        const auto x = static_cast<float>(next_real());
        std::memcpy(p, &x, sizeof x);
      } else {
        std::uint64_t x = next_integer(is_signed(type), size);
        if constexpr (std::endian::native == std::endian::big) x <<= 64 - 8 * size;
        std::memcpy(p, &x, size);
      }
      report_progress();
    }
  }
  /// Moves behind n numbers.
  void skip_values(vtk_number type, std::uint64_t n) {
    if (binary_) at += type == vtk_number::bit ? (n + 7) / 8 : n * vtk_names_of(type).size;
    for (; !binary_ && n > 0; --n) {
      skip();
      if (word().empty()) reject(at, {"a number"});
    }
  }
};

}  // namespace concino::detail
