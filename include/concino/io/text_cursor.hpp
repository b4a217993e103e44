// Reading text: where a reader stands, and how it complains. Lines are counted only when there is something to complain about.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/progress.hpp>
#include <concino/io/detail/characters.hpp>
#include <concino/io/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace concino {

/// A place in a text, with complaints that name the line and say what stands there.
///
///   token_cursor in(text, "a.txt", nullptr, '#');       // words with blanks or line ends between them; # begins a comment
///   const auto n = in.next_count("the number of verts", 6);
///   for (std::uint64_t i = 0; i < n; ++i) points.push_back({in.next_real("x"), in.next_real("y"), in.next_real("z")});
///
/// The text has to stay where it is. Errors: parse_error by fail() and by all that read numbers; cancelled by report_progress().
class text_cursor {
 public:
  const char* at;

 private:
  const char* begin_;
  const char* end_;
  const char* next_report_;
  std::string_view name_;
  const concino::progress* progress_;
  mutable const char* counted_;  // lines up to here, so that many complaints in a row cost one walk
  mutable std::size_t lines_ = 1;

 public:
  /// `name` appears in errors. A byte order mark is skipped.
  text_cursor(std::string_view text, std::string_view name, const concino::progress* on_progress = nullptr)
      : at(text.data()), begin_(at), end_(at + text.size()), next_report_(end_), name_(name), progress_(on_progress), counted_(begin_) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") at += 3;
    if (progress_ && *progress_) next_report_ = at;
  }

  const char* begin() const { return begin_; }
  const char* end() const { return end_; }
  std::string_view name() const { return name_; }
  bool at_end() const { return at == end_; }
  std::uint64_t left() const { return static_cast<std::uint64_t>(end_ - at); }

  /// Says how far it is, about a hundred times a file.
  void report_progress() {
    if (at >= next_report_ && next_report_ != end_) [[unlikely]] report_progress_now();
  }

 private:
  [[gnu::noinline, gnu::cold]] void report_progress_now() {
    detail::report_progress(*progress_, static_cast<double>(at - begin_) / static_cast<double>(end_ - begin_), "reading");
    next_report_ = static_cast<std::size_t>(end_ - at) > 1 ? at + std::min<std::ptrdiff_t>(end_ - at, (end_ - begin_) / 100 + 1) : end_;
  }

 public:
  /// Line of a place, from 1; LF, CRLF and CR each end one. The end of the text counts as the end of its last line that says something.
  [[gnu::noinline, gnu::cold]] std::size_t line_of(const char* place) const {
    if (place == end_) while (place != begin_ && detail::is_space(place[-1])) --place;
    if (place < counted_) {
      counted_ = begin_;
      lines_ = 1;
    }
    for (; counted_ != place; ++counted_)
      lines_ += *counted_ == '\n' ? (counted_ == begin_ || counted_[-1] != '\r') : *counted_ == '\r';
    return lines_;
  }

  /// Errors: parse_error with the line of a place; by default it says what stands there.
  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* place, core::message expected, core::message found) const {
    throw parse_error(std::string(name_), line_of(place), core::joined(expected), core::joined(found));
  }
  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* place, const char* expected) const { fail(place, {expected}, {found_at(place)}); }
  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* place, core::message expected) const { fail(place, expected, {found_at(place)}); }
  /// Errors: unsupported, for more elements than descriptors can name.
  [[noreturn, gnu::noinline, gnu::cold]] void fail_to_count(const char* what) const {
    core::throw_joined<unsupported>({name_, ": more than 4294967294 ", what});
  }

  /// What stands at a place, as errors call it: its first word, of at most 40 characters, or that a line or the file ends there.
  [[gnu::noinline, gnu::cold]] std::string found_at(const char* place) const {
    if (begin_ == end_) return "an empty file";
    if (place == end_) return "the end of the file";
    if (detail::is_line_end(*place)) return "the end of the line";
    std::string found = "'";
    for (const char* p = place; p != end_ && !detail::is_space(*p); ++p) {
      if (p - place == 40) {
        found += "...";
        break;
      }
      if (*p >= 32 && *p < 127) found += *p;
      else (found += "\\x") += {"0123456789abcdef"[static_cast<unsigned char>(*p) >> 4], "0123456789abcdef"[*p & 15]};
    }
    return core::joined({found, "'"});
  }

  /// To the end of the line.
  void skip_line() {
    while (at != end_ && !detail::is_line_end(*at)) ++at;
  }

  /// Blanks and line ends; from `comment` to the end of its line too, if that is not 0.
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

  /// What stands here up to the next blank or line end.
  std::string_view word() {
    const char* from = at;
    while (at != end_ && !detail::is_space(*at)) ++at;
    return {from, static_cast<std::size_t>(at - from)};
  }

  /// A finite real that ends where a blank, a line or a comment begins.
  double real(const char* expected, char comment = '#') {
    double x = 0;
    const char* p = parse_real(at, end_, x);
    if (!p || !ends_token(p, comment)) fail(at, expected);
    if (!std::isfinite(x)) fail(at, {expected, ", a finite number"});
    at = p;
    return x;
  }

  /// An integer of at most 18 digits that ends there.
  std::int64_t integer(const char* expected, char comment = '#') {
    std::int64_t i = 0;
    const char* p = parse_integer(at, end_, i);
    if (!p || !ends_token(p, comment)) fail(at, expected);
    at = p;
    return i;
  }

  /// Whether a number that ends at p ends there as a word: nothing else follows but a blank, a line end, a comment or a backslash.
  bool ends_token(const char* p, char comment) const { return p == end_ || detail::is_space(*p) || *p == comment || *p == '\\'; }
};

/// The same for formats where a line end is like any blank: numbers follow one another wherever they stand.
struct token_cursor : text_cursor {
  static constexpr std::uint64_t max_count = 0xFFFFFFFEu;  // elements of a kind: ids have 32 bits, and one of them means "none"
  char comment = 0;

  token_cursor(std::string_view text, std::string_view name, const concino::progress* on_progress, char comment_)
      : text_cursor(text, name, on_progress), comment(comment_) {}

  /// To the next word.
  void skip() {
    if (!at_end() && detail::is_space(*at)) ++at;  // mostly one blank, then the next word
    if (at_end() || detail::is_space(*at) || *at == comment) skip_space(comment);
  }
  /// The next word as a number; `expected` says what it means.
  double next_real(const char* expected) {
    skip();
    return real(expected, comment);
  }
  std::int64_t next_integer(const char* expected) {
    skip();
    return integer(expected, comment);
  }
  /// A number of elements that take at least `bytes` each. What a file announces is not believed: reserve no more than reservable() says, and
  /// read until the elements or the file end.
  std::uint64_t next_count(const char* what, std::uint64_t bytes) {
    skip();
    const char* const from = at;
    const std::int64_t n = integer(what, comment);
    if (n < 0) fail(from, what);
    if (static_cast<std::uint64_t>(n) > max_count && reservable(max_count + 1, bytes) > max_count) fail_to_count("elements of one kind");
    return static_cast<std::uint64_t>(n);
  }
  /// How many of n announced elements the rest of the file can hold; the last needs no line end.
  std::size_t reservable(std::uint64_t n, std::uint64_t bytes) const { return static_cast<std::size_t>(std::min(n, (left() + 1) / bytes)); }
  /// An index from 1 to `bound`, made to count from 0.
  std::uint32_t next_index(std::uint64_t bound, const char* what) {
    skip();
    std::int64_t i = 0;
    const char* p = parse_integer(at, end(), i);
    if (!p || !ends_token(p, comment) || i < 1 || static_cast<std::uint64_t>(i) > bound) fail(at, {what, " from 1 to ", bound});
    at = p;
    return static_cast<std::uint32_t>(i - 1);
  }
};

}  // namespace concino
