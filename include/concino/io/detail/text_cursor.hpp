// Where a reader stands in a text, and how it complains. Lines are counted only when there is something to complain about.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/progress.hpp>
#include <concino/io/detail/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
inline bool is_line_end(char c) { return c == '\n' || c == '\r'; }
inline bool is_space(char c) { return is_blank(c) || is_line_end(c); }
inline bool is_letter(char c) { return static_cast<unsigned char>((c | 0x20) - 'a') < 26; }

inline constexpr std::uint64_t max_ids = 0xFFFFFFFEu;  // 32-bit ids, one of which means "none"

class text_cursor {
 public:
  const char* at;

 private:
  const char* begin_;
  const char* end_;
  const char* next_tell_;
  std::string_view name_;
  const concino::progress* progress_;
  mutable const char* counted_;  // lines up to here, so that many complaints in a row cost one walk
  mutable std::size_t lines_ = 1;

 public:
  /// `name` appears in errors. A byte order mark is skipped.
  text_cursor(std::string_view text, std::string_view name, const concino::progress* progress = nullptr)
      : at(text.data()), begin_(at), end_(at + text.size()), next_tell_(end_), name_(name), progress_(progress), counted_(begin_) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") at += 3;
    if (progress_ && *progress_) next_tell_ = at;
  }

  const char* begin() const { return begin_; }
  const char* end() const { return end_; }
  std::string_view name() const { return name_; }
  bool at_end() const { return at == end_; }
  std::uint64_t left() const { return static_cast<std::uint64_t>(end_ - at); }

  /// Says how far it is, about a hundred times a file.
  void tell() {
    if (at >= next_tell_ && next_tell_ != end_) [[unlikely]] tell_now();
  }

 private:
  [[gnu::noinline, gnu::cold]] void tell_now() {
    detail::tell(*progress_, static_cast<double>(at - begin_) / static_cast<double>(end_ - begin_), "reading");
    next_tell_ = static_cast<std::size_t>(end_ - at) > 1 ? at + std::min<std::ptrdiff_t>(end_ - at, (end_ - begin_) / 100 + 1) : end_;
  }

 public:

  /// Line of a place, from 1; LF, CRLF and CR each end one. The end of the text counts as the end of its last line that says something.
  [[gnu::noinline, gnu::cold]] std::size_t line_of(const char* place) const {
    if (place == end_) while (place != begin_ && is_space(place[-1])) --place;
    if (place < counted_) {
      counted_ = begin_;
      lines_ = 1;
    }
    for (; counted_ != place; ++counted_)
      lines_ += *counted_ == '\n' ? (counted_ == begin_ || counted_[-1] != '\r') : *counted_ == '\r';
    return lines_;
  }

  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* place, core::message expected, core::message found) const {
    throw parse_error(std::string(name_), line_of(place), core::joined(expected), core::joined(found));
  }
  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* place, const char* expected) const { fail(place, {expected}, {found_at(place)}); }
  /// Says what stands at `place` itself.
  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* place, core::message expected) const { fail(place, expected, {found_at(place)}); }
  [[noreturn, gnu::noinline, gnu::cold]] void fail_to_count(const char* what) const {
    core::throw_joined<unsupported>({name_, ": more than 4294967294 ", what});
  }

  [[gnu::noinline, gnu::cold]] std::string found_at(const char* place) const {
    if (begin_ == end_) return "an empty file";
    if (place == end_) return "the end of the file";
    if (is_line_end(*place)) return "the end of the line";
    std::string found = "'";
    for (const char* p = place; p != end_ && !is_space(*p); ++p) {
      if (p - place == 40) {
        found += "...";
        break;
      }
      if (*p >= 32 && *p < 127) found += *p;
      else (found += "\\x") += {"0123456789abcdef"[static_cast<unsigned char>(*p) >> 4], "0123456789abcdef"[*p & 15]};
    }
    return core::joined({found, "'"});
  }

  void skip_line() {
    while (at != end_ && !is_line_end(*at)) ++at;
  }

  /// Blanks and line ends; from `comment` to the end of its line too, if that is not 0.
  void skip_space(char comment = 0) {
    for (; at != end_; ++at) {
      if (comment && *at == comment) {
        skip_line();
        if (at == end_) return;
      } else if (!is_space(*at)) {
        return;
      }
    }
  }

  std::string_view word() {
    const char* from = at;
    while (at != end_ && !is_space(*at)) ++at;
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

  std::int64_t integer(const char* expected, char comment = '#') {
    std::int64_t i = 0;
    const char* p = parse_integer(at, end_, i);
    if (!p || !ends_token(p, comment)) fail(at, expected);
    at = p;
    return i;
  }

  bool ends_token(const char* p, char comment) const { return p == end_ || is_space(*p) || *p == comment || *p == '\\'; }
};

/// The same for formats where a line end is like any blank: numbers follow one another wherever they stand.
struct token_cursor : text_cursor {
  char comment = 0;

  token_cursor(std::string_view text, std::string_view name, const concino::progress* progress, char comment_)
      : text_cursor(text, name, progress), comment(comment_) {}

  void skip() {
    if (!at_end() && is_space(*at)) ++at;  // mostly one blank, then the next word
    if (at_end() || is_space(*at) || *at == comment) skip_space(comment);
  }
  double next_real(const char* expected) {
    skip();
    return real(expected, comment);
  }
  std::int64_t next_integer(const char* expected) {
    skip();
    return integer(expected, comment);
  }
  /// A number of elements that take at least `bytes` each. What a file announces is not believed: reserve no more than room() says, and
  /// read until the elements or the file end.
  std::uint64_t next_count(const char* what, std::uint64_t bytes) {
    skip();
    const char* const from = at;
    const std::int64_t n = integer(what, comment);
    if (n < 0) fail(from, what);
    if (static_cast<std::uint64_t>(n) > max_ids && room(max_ids + 1, bytes) > max_ids) fail_to_count("elements of one kind");
    return static_cast<std::uint64_t>(n);
  }
  /// How many of n announced elements the rest of the file can hold; the last needs no line end.
  std::size_t room(std::uint64_t n, std::uint64_t bytes) const { return static_cast<std::size_t>(std::min(n, (left() + 1) / bytes)); }
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

/// The first corner that a list of verts repeats, or its length: by sorting, for lists of many.
[[gnu::noinline, gnu::cold]] inline std::size_t first_repeated_of_many(const vert_id* verts, std::size_t n, std::vector<vert_id>& scratch) {
  scratch.assign(verts, verts + n);
  std::sort(scratch.begin(), scratch.end());
  if (std::adjacent_find(scratch.begin(), scratch.end()) == scratch.end()) return n;
  std::vector<std::size_t> place(n);
  for (std::size_t i = 0; i < n; ++i) place[i] = i;
  std::sort(place.begin(), place.end(), [&](std::size_t a, std::size_t b) { return verts[a] != verts[b] ? verts[a] < verts[b] : a < b; });
  std::size_t first = n;
  for (std::size_t i = 1; i < n; ++i)
    if (verts[place[i]] == verts[place[i - 1]]) first = std::min(first, place[i]);
  return first;
}

/// The same, quadratic for the few corners that polys have.
inline std::size_t first_repeated(const vert_id* verts, std::size_t n, std::vector<vert_id>& scratch) {
  if (n > 32) return first_repeated_of_many(verts, n, scratch);
  for (std::size_t i = 1; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (verts[i] == verts[j]) return i;
  return n;
}

}  // namespace concino::detail
