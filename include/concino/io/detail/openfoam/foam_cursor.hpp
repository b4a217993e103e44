// Reads the words and lists of an OpenFOAM file, as text or as binary numbers.
#pragma once

#include <concino/io/text_cursor.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace concino::detail {

/// How a file stores numbers, as its header says.
struct foam_encoding {
  bool binary = false;
  bool swapped = std::endian::native == std::endian::big;  // the bytes of each number are in the other order
  std::size_t label_size = 4, scalar_size = 8;             // in bytes
};

/// A position in an OpenFOAM file. Errors in binary lists name the byte, and the line where the list begins, as there
/// are no lines after it.
class foam_cursor : public text_cursor {
  const char* binary_list_ = nullptr;  // the beginning of the binary list that is being read

  bool ends_number(const char* p) const {
    return p == end() || is_space(*p) || std::string_view("(){};/").find(*p) != std::string_view::npos;
  }

  [[noreturn, gnu::noinline, gnu::cold]] void fail_count(const char* position, std::uint64_t n,
                                                         std::uint64_t most) const {
    fail(position, {"a number of entries, at most ", most}, {n});
  }

  /// Reads n binary numbers of T. Needs: room for them.
  template<class T, class Use>
  void take(std::uint64_t n, const Use& use) {
    for (; n > 0; --n) {
      T x;
      const char* const position = at;
      if (encoding.swapped) std::reverse_copy(at, at + sizeof x, reinterpret_cast<char*>(&x));
      else std::memcpy(&x, at, sizeof x);
      at += sizeof x;
      use(position, x);
    }
  }

  /// Begins a binary list of n numbers of so many bytes. Errors: parse_error if the file is too short for them.
  void begin_binary(std::uint64_t n, std::size_t size) {
    binary_list_ = at;
    if (at == end() || *at != '(') reject(at, {"the '(' of a binary list"}, {found_at(at)});
    ++at;
    if (left() == 0 || n > (left() - 1) / size)
      reject(at, {"a list that ends before the file"}, {n, " numbers of ", 8 * size, " bits, and ", left(), " bytes"});
  }
  void end_binary() {
    if (*at != ')') reject(at, {"the ')' of a binary list"}, {"another value"});
    ++at;
    binary_list_ = nullptr;
  }

 public:
  foam_encoding encoding;

  using text_cursor::text_cursor;

  /// Errors: parse_error. In binary lists it names the byte.
  [[noreturn, gnu::noinline, gnu::cold]] void reject(const char* position, core::message expected,
                                                     core::message found) const {
    if (!binary_list_) fail(position, expected, found);
    fail(binary_list_, expected, {core::joined(found), " at byte ", static_cast<std::uint64_t>(position - begin())});
  }

  /// Skips blanks, line ends and comments.
  void skip() {
    for (;;) {
      skip_space();
      if (left() < 2 || *at != '/') return;
      if (at[1] == '/') {
        skip_line();
      } else if (at[1] == '*') {
        const std::string_view rest(at, static_cast<std::size_t>(left()));
        const std::size_t past = rest.find("*/", 2);
        if (past == rest.npos) fail(at, {"a comment that ends in */"}, {"the end of the file"});
        at += past + 2;
      } else {
        return;
      }
    }
  }
  /// Whether the next character is c; if so, moves behind it.
  bool next_is(char c) {
    skip();
    if (at_end() || *at != c) return false;
    ++at;
    return true;
  }
  void require(char c, const char* expected) {
    if (!next_is(c)) fail(at, expected);
  }

  /// Reads a word: up to a blank, `;`, `{`, `}`, a quotation mark, or a parenthesis without partner. It may be empty.
  std::string_view next_word() {
    skip();
    const char* const from = at;
    int depth = 0;
    for (; !at_end() && !is_space(*at) && std::string_view(";{}\"").find(*at) == std::string_view::npos; ++at) {
      if (*at == ')' && depth == 0) break;
      depth += *at == '(' ? 1 : *at == ')' ? -1 : 0;
    }
    return {from, static_cast<std::size_t>(at - from)};
  }

  std::int64_t next_integer(const char* expected) {
    skip();
    std::int64_t i = 0;
    const char* const p = parse_integer(at, end(), i);
    if (!p || !ends_number(p)) fail(at, expected);
    at = p;
    return i;
  }
  double next_real(const char* expected) {
    skip();
    double x = 0;
    const char* const p = parse_real(at, end(), x);
    if (!p || !ends_number(p)) fail(at, expected);
    if (!std::isfinite(x)) fail(at, {expected, ", a finite number"});
    at = p;
    return x;
  }

  /// Reads the number of entries of a list. Errors: parse_error if there are more than `most`, or more than the file
  /// can hold.
  std::uint64_t next_count(const char* what, std::uint64_t most) {
    skip();
    const char* const from = at;
    const std::int64_t n = next_integer(what);
    if (n < 0) fail(from, what);
    // an entry has at least one character, and a blank after it
    const std::uint64_t room = (left() + 1) / 2;
    if (static_cast<std::uint64_t>(n) > most) fail_count(from, static_cast<std::uint64_t>(n), most);
    if (skip(); !at_end() && *at == '{') {
      if (static_cast<std::uint64_t>(n) > file_size()) fail_count(from, static_cast<std::uint64_t>(n), file_size());
    } else if (static_cast<std::uint64_t>(n) > room) {
      fail(from, {"a number of entries that fits into the file"}, {n, " entries, and ", left(), " bytes"});
    }
    return static_cast<std::uint64_t>(n);
  }
  /// The size of the file in bytes.
  std::uint64_t file_size() const { return static_cast<std::uint64_t>(end() - begin()); }

  /// Reads a list of labels: N(1 2 3), N{1}, or in binary N(bytes). Calls size(N), then use(position, label) for each.
  /// Errors: parse_error for more than `most`.
  template<class Size, class Use>
  void read_labels(const char* what, std::uint64_t most, const Size& size, const Use& use) {
    skip();
    if (std::string_view(at, static_cast<std::size_t>(left())).starts_with("List<label>")) at += 11;
    const std::uint64_t n = next_count(what, most);
    size(n);
    if (next_is('{')) {
      skip();
      const char* const position = at;
      const std::int64_t i = next_integer(what);
      for (std::uint64_t k = 0; k < n; ++k) use(position, i);
      return require('}', "the '}' of a list of equal labels");
    }
    if (n == 0 && encoding.binary && (at_end() || *at != '(')) return;
    if (encoding.binary && n > 0) {
      begin_binary(n, encoding.label_size);
      if (encoding.label_size == 8) take<std::int64_t>(n, use);
      else take<std::int32_t>(n, use);
      return end_binary();
    }
    require('(', "the '(' of a list");
    for (std::uint64_t k = 0; k < n; ++k) {
      skip();
      const char* const position = at;
      use(position, next_integer(what));
    }
    require(')', "the ')' after the last entry of a list");
  }

  /// Reads a list of vectors in the same way: N((0 0 0) (1 0 0)).
  template<class Size, class Use>
  void read_vectors(const char* what, std::uint64_t most, const Size& size, const Use& use) {
    const std::uint64_t n = next_count(what, most);
    size(n);
    const auto next = [&] {
      double x[3];
      require('(', "the '(' of a point");
      for (double& k : x) k = next_real("a coordinate");
      require(')', "the ')' of a point");
      use(x[0], x[1], x[2]);
      report_progress();
    };
    if (encoding.binary && n > 0 && *at == '(') {
      begin_binary(n, 3 * encoding.scalar_size);
      double x[3];
      std::size_t k = 0;
      const auto add = [&](const char* position, double c) {
        if (!std::isfinite(c)) reject(position, {"a coordinate, a finite number"}, {"another value"});
        x[k++] = c;
        if (k == 3) use(x[0], x[1], x[2]), k = 0;
      };
      if (encoding.scalar_size == 4)
        take<float>(3 * n, [&](const char* p, float c) { add(p, static_cast<double>(c)); });
      else take<double>(3 * n, add);
      end_binary();
      return report_progress();
    }
    if (n == 0 && encoding.binary && (at_end() || *at != '(')) return;
    if (next_is('{')) {
      const char* const first = at;
      for (std::uint64_t k = 0; k < n; ++k) at = first, next();
      return require('}', "the '}' of a list of equal points");
    }
    require('(', "the '(' of a list");
    for (std::uint64_t k = 0; k < n; ++k) next();
    require(')', "the ')' after the last point");
  }

  /// Errors: parse_error unless only blanks and comments follow.
  void require_end(const char* expected) {
    skip();
    if (!at_end()) fail(at, expected);
  }
};

}  // namespace concino::detail
