// A position in a text that is parsed, and the errors that name its line. Lines are counted only when an error or a
// note needs them.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/progress.hpp>
#include <concino/io/detail/text/characters.hpp>
#include <concino/io/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace concino {

namespace detail {

/// A text without the characters NUL and Ctrl-Z at its end, which some programs write behind the last line.
inline std::string_view text_without_padding(std::string_view text) {
  const std::size_t last = text.find_last_not_of(std::string_view("\0\x1a \t\r\n", 6));
  const std::string_view rest = text.substr(last == text.npos ? 0 : last + 1);
  return rest.find_first_of(std::string_view("\0\x1a", 2)) == rest.npos ? text
                                                                        : text.substr(0, text.size() - rest.size());
}

}  // namespace detail

/// A position in a text. Its errors name the line and quote the word that was found there.
///
///   token_cursor in(text, "a.txt", nullptr, '#');       // words with blanks or line ends between them; # begins a
///   comment const auto n = in.next_count("the number of verts", 6);
///   for (std::uint64_t i = 0; i < n; ++i) points.push_back({in.next_real("x"), in.next_real("y"), in.next_real("z")});
///
/// The text must stay in place while it is read. Errors: parse_error by fail() and by all functions that read numbers;
/// cancelled by report_progress().
class text_cursor {
 public:
  const char* at;

 private:
  const char* begin_;
  const char* end_;
  const char* next_report_;
  std::string_view name_;
  const concino::progress* progress_;
  mutable const char* counted_;  // lines are counted up to here, so that many calls of line_of cost one pass
  mutable std::size_t lines_ = 1;

 public:
  /// `name` is the name of the text in errors. A byte order mark is skipped.
  text_cursor(std::string_view text, std::string_view name, const concino::progress* on_progress = nullptr)
      : at(text.data()), begin_(at), end_(at + text.size()), next_report_(end_), name_(name), progress_(on_progress),
        counted_(begin_) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") at += 3;
    if (progress_ && *progress_) next_report_ = at;
  }

  const char* begin() const { return begin_; }
  const char* end() const { return end_; }
  std::string_view name() const { return name_; }
  bool at_end() const { return at == end_; }
  std::uint64_t left() const { return static_cast<std::uint64_t>(end_ - at); }

  /// Reports the fraction that has been read, about a hundred times per file.
  void report_progress() {
    if (at >= next_report_ && next_report_ != end_) report_progress_now();
  }

 private:
  void report_progress_now() {
    detail::report_progress(*progress_, static_cast<double>(at - begin_) / static_cast<double>(end_ - begin_),
                            "reading");
    next_report_ = static_cast<std::size_t>(end_ - at) > 1
                       ? at + std::min<std::ptrdiff_t>(end_ - at, (end_ - begin_) / 100 + 1)
                       : end_;
  }

 public:
  /// The line of a position, from 1; LF, CRLF and CR each end a line. The end of the text counts as the end of its last
  /// line that is not blank.
  std::size_t line_of(const char* position) const {
    if (position == end_) while (position != begin_ && detail::is_space(position[-1])) --position;
    if (position < counted_) {
      counted_ = begin_;
      lines_ = 1;
    }
    for (; counted_ != position; ++counted_)
      lines_ += *counted_ == '\n' ? (counted_ == begin_ || counted_[-1] != '\r') : *counted_ == '\r';
    return lines_;
  }

  /// Errors: parse_error with the line of a position; without `found` it quotes the word there.
  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* position, core::message expected,
                                                   core::message found) const {
    throw parse_error(std::string(name_), line_of(position), core::joined(expected), core::joined(found));
  }
  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* position, const char* expected) const {
    fail(position, {expected}, {found_at(position)});
  }
  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* position, core::message expected) const {
    fail(position, expected, {found_at(position)});
  }
  /// Errors: unsupported, for more elements than there are ids.
  [[noreturn, gnu::noinline, gnu::cold]] void fail_to_count(const char* what) const {
    core::throw_joined<unsupported>({name_, ": more than 4294967294 ", what});
  }

  /// The text at a position, for errors: its first word, at most 40 characters, or that the line or the file ends
  /// there.
  std::string found_at(const char* position) const {
    if (begin_ == end_) return "an empty file";
    if (position == end_) return "the end of the file";
    if (detail::is_line_end(*position)) return "the end of the line";
    std::string found = "'";
    for (const char* p = position; p != end_ && !detail::is_space(*p); ++p) {
      if (p - position == 40) {
        found += "...";
        break;
      }
      if (*p >= 32 && *p < 127) found += *p;
      else (found += "\\x") += {"0123456789abcdef"[static_cast<unsigned char>(*p) >> 4], "0123456789abcdef"[*p & 15]};
    }
    return core::joined({found, "'"});
  }

  /// Moves to the end of the line.
  void skip_line() {
    while (at != end_ && !detail::is_line_end(*at)) ++at;
  }

  /// Skips blanks and line ends, and unless `comment` is 0, also comments from this character to the end of the line.
  void skip_space(char comment = 0) {
    for (; at != end_; ++at) {
      if (comment && *at == comment) {
        skip_line();
        if (at == end_) return;
      } else if (!detail::is_space(*at)) {
        return;
      }
    }
  }

  /// Reads up to the next blank or line end.
  std::string_view word() {
    const char* from = at;
    while (at != end_ && !detail::is_space(*at)) ++at;
    return {from, static_cast<std::size_t>(at - from)};
  }

  /// Reads a finite real number. It must be followed by a blank, a line end, a comment or the end of the text.
  double real(const char* expected, char comment = '#') {
    double x = 0;
    const char* p = parse_real(at, end_, x);
    if (!p || !ends_token(p, comment)) fail(at, expected);
    if (!std::isfinite(x)) fail(at, {expected, ", a finite number"});
    at = p;
    return x;
  }

  /// Reads an integer of at most 18 digits, which must end in the same way.
  std::int64_t integer(const char* expected, char comment = '#') {
    std::int64_t i = 0;
    const char* p = parse_integer(at, end_, i);
    if (!p || !ends_token(p, comment)) fail(at, expected);
    at = p;
    return i;
  }

  /// Whether a word can end at p: only a blank, a line end, a comment or a backslash follows, or the end of the text.
  bool ends_token(const char* p, char comment) const {
    return p == end_ || detail::is_space(*p) || *p == comment || *p == '\\';
  }
};

/// A cursor for formats where a line end is like any other blank, so that lines have no meaning.
struct token_cursor : text_cursor {
  static constexpr std::uint64_t max_count = 0xFFFFFFFEu;  // elements of one kind: ids have 32 bits, and one of them
                                                           // means "none"
  char comment = 0;

  token_cursor(std::string_view text, std::string_view name, const concino::progress* on_progress, char comment_)
      : text_cursor(text, name, on_progress), comment(comment_) {}

  /// Moves to the next word.
  void skip() {
    if (!at_end() && detail::is_space(*at)) ++at;  // usually one blank separates words
    if (at_end() || detail::is_space(*at) || *at == comment) skip_space(comment);
  }
  /// Reads the next word as a number; `expected` is its meaning, for errors.
  double next_real(const char* expected) {
    skip();
    return real(expected, comment);
  }
  std::int64_t next_integer(const char* expected) {
    skip();
    return integer(expected, comment);
  }
  /// Reads a number of elements, each of which takes at least `bytes` in the file. The number may be wrong: reserve no
  /// more than reservable(), and read until the elements or the file end.
  std::uint64_t next_count(const char* what, std::uint64_t bytes) {
    skip();
    const char* const from = at;
    const std::int64_t n = integer(what, comment);
    if (n < 0) fail(from, what);
    if (static_cast<std::uint64_t>(n) > max_count && reservable(max_count + 1, bytes) > max_count)
      fail_to_count("elements of one kind");
    return static_cast<std::uint64_t>(n);
  }
  /// How many of n elements the rest of the file can hold; the last one needs no line end.
  std::size_t reservable(std::uint64_t n, std::uint64_t bytes) const {
    return static_cast<std::size_t>(std::min(n, (left() + 1) / bytes));
  }
  /// Reads the index of one of `bound` elements, the first of which has index `first`, 0 or 1. Returns it as counted
  /// from 0.
  std::uint32_t next_index(std::uint64_t bound, const char* what, std::uint32_t first = 1) {
    skip();
    std::int64_t i = 0;
    const char* p = parse_integer(at, end(), i);
    if (!p || !ends_token(p, comment) || static_cast<std::uint64_t>(i - first) >= bound) fail_index(bound, what, first);
    at = p;
    return static_cast<std::uint32_t>(i - first);
  }

 private:
  [[noreturn, gnu::noinline, gnu::cold]] void fail_index(std::uint64_t bound, const char* what,
                                                         std::uint32_t first) const {
    if (bound == 0) fail(at, {what, ", but there is nothing to refer to"});
    fail(at, {what, " from ", first, " to ", bound - 1 + first});
  }
};

}  // namespace concino
