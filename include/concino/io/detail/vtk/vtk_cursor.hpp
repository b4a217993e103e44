// Reads words and arrays of numbers of legacy VTK files, as text or big-endian.
#pragma once

#include <concino/io/detail/text/encoded_name.hpp>
#include <concino/io/detail/values/typed_number_cursor.hpp>

#include <string>

namespace concino::detail {

/// A position in a legacy VTK file. The line that errors name in binary files is that of the word BINARY.
class vtk_cursor : public typed_number_cursor {
 protected:
  using typed_number_cursor::typed_number_cursor;

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
    return decoded_name(w);
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

  void read_bits(bool* to, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i)
      to[i] = binary_ ? (static_cast<unsigned char>(at[i / 8]) >> (7 - i % 8) & 1) != 0 : next_integer(false, 1) != 0;
    if (binary_) at += (n + 7) / 8;
  }
  /// The same with any type of numbers.
  void read_values_of(vtk_number type, void* to, std::size_t n) {
    if (type == vtk_number::bit) read_bits(static_cast<bool*>(to), n);
    else typed_number_cursor::read_values_of(type, to, n);
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
