// Reads the words, strings and lists of numbers of Open Inventor files, and counts nodes.
#pragma once

#include <concino/io/detail/values/name_runs.hpp>
#include <concino/io/text_cursor.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// Counts nodes by their types, of which there may be very many.
class node_counts {
  static constexpr std::size_t max_types = 20;
  name_table types_;
  std::vector<std::size_t> counts_;

 public:
  void add(std::string_view type) {
    const bool is_another = types_.find(type) == name_table::none && types_.size() >= max_types;
    const std::size_t i = types_.add(is_another ? "of other types" : type);
    counts_.resize(std::max(counts_.size(), i + 1));
    ++counts_[i];
  }
  void report(std::vector<std::string>& sentences) const {
    for (std::size_t i = 0; i < counts_.size(); ++i)
      sentences.push_back(core::joined({counts_[i], " nodes ", types_[i]}));
  }
};

/// A cursor for text in which blanks, line ends, commas and comments separate words, and braces and brackets are words
/// of their own.
class iv_cursor : protected text_cursor {
  static bool is_separator(char c) { return is_space(c) || c == ','; }
  static bool is_punctuation(char c) { return c == '{' || c == '}' || c == '[' || c == ']' || c == '"' || c == '#'; }

 protected:
  using text_cursor::text_cursor;

  /// Moves to the next word.
  void skip() {
    for (; at != end(); ++at) {
      if (*at == '#') {
        skip_line();
        if (at == end()) return;
      } else if (!is_separator(*at)) {
        return;
      }
    }
  }

  /// Skips the first line.
  /// Errors: parse_error if it is not that of an Open Inventor file; unsupported if the file is binary.
  void skip_header() {
    const char* const from = at;
    skip_line();
    const std::string_view line{from, static_cast<std::size_t>(at - from)};
    if (!line.starts_with("#Inventor")) fail(from, "#Inventor V2.1 ascii");
    if (line.find("binary") != line.npos)
      core::throw_joined<unsupported>(
          {name(),
           ": binary Open Inventor files cannot be read; convert it to ASCII, with ivcat of Coin or Open Inventor"});
  }

  bool ends_word(const char* p) const { return p == end() || is_separator(*p) || is_punctuation(*p); }

  std::string_view word() {
    const char* const from = at;
    while (!ends_word(at)) ++at;
    return {from, static_cast<std::size_t>(at - from)};
  }

  /// Skips a string. A backslash escapes the character after it.
  void skip_string() {
    const char* const from = at++;
    for (; at != end() && *at != '"'; ++at)
      if (*at == '\\' && ++at == end()) break;
    if (at == end()) fail(from, {"a string that ends"}, {"one without a closing quotation mark"});
    ++at;
  }

  double real(const char* expected) {
    double x = 0;
    const char* const p = parse_real(at, end(), x);
    if (!p || !ends_word(p)) fail(at, expected);
    if (!std::isfinite(x)) fail(at, {expected, ", a finite number"});
    at = p;
    return x;
  }

  std::int64_t integer(const char* expected) {
    std::int64_t i = 0;
    const char* const p = parse_integer(at, end(), i);
    if (!p || !ends_word(p)) fail(at, expected);
    at = p;
    return i;
  }

  /// Calls next() at each value of the field whose name was read last: the values in brackets, or a single one.
  template<class Next>
  void for_each_value(const char* expected, const Next& next) {
    skip();
    if (at == end()) fail(at, expected);
    if (*at != '[') return next();
    ++at;
    for (skip(); at != end() && *at != ']'; skip()) {
      next();
      report_progress();
    }
    if (at == end()) fail(at, {expected, " or ']'"});
    ++at;
  }
};

}  // namespace concino::detail
