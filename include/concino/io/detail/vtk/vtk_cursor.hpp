// Reads words and arrays of numbers of legacy VTK files, as text or big-endian.
#pragma once

#include <concino/io/detail/vtk/vtk_numbers.hpp>
#include <concino/io/text_cursor.hpp>

#include <bit>
#include <charconv>
#include <limits>
#include <string>

namespace concino::detail {

/// A position in a legacy VTK file. In binary files errors name the byte, and the line of the word BINARY, as there are
/// no lines after it.
class vtk_cursor : public token_cursor {
 protected:
  bool binary_ = false;
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

  /// Reads the next word, in lower case. Line ends are blanks.
  std::string next_keyword() {
    skip();
    std::string w(word().substr(0, 64));
    for (char& c : w)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
    return w;
  }
  /// Reads the next word, with %XX for characters that words cannot contain.
  std::string next_name() {
    skip();
    const char* const from = at;
    const std::string_view w = word();
    if (w.empty()) reject(from, {"a name"});
    std::string name;
    for (std::size_t i = 0; i < w.size(); ++i) {
      unsigned code = 0;
      if (w[i] == '%' && i + 2 < w.size() && std::from_chars(&w[i + 1], &w[i + 1] + 2, code, 16).ptr == &w[i + 1] + 2) {
        name += static_cast<char>(code);
        i += 2;
      } else {
        name += w[i];
      }
    }
    return name;
  }
  /// Reads a number that is written as text in binary files too, at least 0.
  std::uint64_t next_number(const char* what) {
    skip();
    std::int64_t i = 0;
    const char* const p = parse_integer(at, end(), i);
    if (!p || !ends_token(p, 0) || i < 0) reject(at, {what});
    at = p;
    return static_cast<std::uint64_t>(i);
  }
  /// The same on the rest of this line; `otherwise` if there is no number.
  std::uint64_t number_on_line(std::uint64_t otherwise) {
    while (!at_end() && is_blank(*at)) ++at;
    std::int64_t i = 0;
    const char* const p = parse_integer(at, end(), i);
    if (!p || !ends_token(p, 0) || i < 0) return otherwise;
    at = p;
    return static_cast<std::uint64_t>(i);
  }
  /// Moves behind the end of the line, where the numbers of a binary file begin.
  void begin_numbers() {
    if (!binary_) return;
    skip_line();
    if (left() > 1 && *at == '\r' && at[1] == '\n') ++at;
    if (!at_end()) ++at;
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
    if constexpr (std::endian::native == std::endian::little) swap_bytes(&x, 1, sizeof x);
    at += sizeof x;
    return x;
  }

  /// Reads n numbers into memory. Needs: begin_numbers() and require_room() for this type.
  template<class T>
  void read_values(T* to, std::size_t n) {
    if (binary_) {
      if (n) std::memcpy(to, at, n * sizeof(T));
      if constexpr (std::endian::native == std::endian::little) swap_bytes(to, n, sizeof(T));
      at += n * sizeof(T);
      report_progress();
    } else {
      for (std::size_t i = 0; i < n; ++i) {
        to[i] = next_value<T>();
        report_progress();
      }
    }
  }
  void read_bits(bool* to, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i)
      to[i] = binary_ ? (static_cast<unsigned char>(at[i / 8]) >> (7 - i % 8) & 1) != 0 : next_integer(false, 1) != 0;
    if (binary_) at += (n + 7) / 8;
  }
  /// The same with any type of numbers.
  void read_values_of(vtk_number type, void* to, std::size_t n) {
    if (type == vtk_number::bit) return read_bits(static_cast<bool*>(to), n);
    if (type == vtk_number::float64) return read_values(static_cast<double*>(to), n);
    const std::size_t size = vtk_names_of(type).size;
    auto* p = static_cast<unsigned char*>(to);
    if (binary_) {
      if (n) std::memcpy(p, at, n * size);
      if constexpr (std::endian::native == std::endian::little) swap_bytes(p, n, size);
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
  /// Moves behind n texts: in text files a line each, in binary files each with its length.
  void skip_strings(std::uint64_t n) {
    for (; n > 0; --n) {
      if (!binary_) {
        skip();
        if (at_end()) reject(at, {"a text"});
        skip_line();
        continue;
      }
      if (at_end()) reject(at, {"a text"});
      const unsigned bytes = 8u >> (static_cast<unsigned char>(*at) >> 6);  // of the length: 8, 4, 2 or 1
      std::uint64_t length = 0;
      if (bytes > left()) reject(end(), {"a text"});
      for (unsigned i = 0; i < bytes; ++i) length = length << 8 | static_cast<unsigned char>(*at++);
      length &= ~std::uint64_t{0} >> (66 - 8 * bytes) ;
      if (length > left()) reject(at, {"a text that fits into the file"}, {"one of ", length, " bytes"});
      at += length;
    }
  }
};

}  // namespace concino::detail
