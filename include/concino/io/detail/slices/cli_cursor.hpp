// The words of text files of the Common Layer Interface: commands, their parameters, and comments.
#pragma once

#include <concino/io/detail/text/characters.hpp>
#include <concino/io/text_cursor.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

namespace concino::detail {

class cli_cursor : protected text_cursor {
 protected:
  const char* last_ = nullptr;  // the end of the last number: where a list ends that is too short

  using text_cursor::text_cursor;

  /// Skips blanks, line ends and comments, which begin and end with //.
  void skip_blanks() {
    for (;;) {
      skip_space();
      if (left() < 2 || at[0] != '/' || at[1] != '/') return;
      const char* const comment = at;
      const auto rest = std::string_view(at + 2, left() - 2);
      const std::size_t end = rest.find("//");
      if (end == std::string_view::npos)
        fail(comment, {"two slashes at the end of the comment"}, {"the end of the file"});
      at += end + 4;
    }
  }

  /// The name of a command, after its $$; empty if there is none.
  std::string_view command() {
    if (left() < 2 || at[0] != '$' || at[1] != '$') return {};
    at += 2;
    const char* const from = at;
    while (!at_end() && is_letter(*at)) ++at;
    return {from, static_cast<std::size_t>(at - from)};
  }

  bool ends_number(const char* p) const { return p == end() || *p == ',' || is_space(*p) || *p == '/' || *p == '$'; }

  /// Moves to the first parameter of a command.
  void begin_parameters(const char* expected) {
    skip_blanks();
    if (at_end() || *at != '/') fail(at, {"/ and ", expected});
    ++at;
    last_ = at;
  }
  /// Whether another parameter follows.
  bool next_parameter() {
    if (!at_end() && *at == ',') {
      ++at;
      return true;
    }
    skip_blanks();
    if (at_end() || *at != ',') return false;
    ++at;
    return true;
  }
  void comma(const char* expected) {
    if (!next_parameter()) fail(last_, {"a comma and ", expected});
  }
  double number(const char* expected) {
    double x = 0;
    const char* p = parse_real(at, end(), x);
    if (!p) {
      skip_blanks();
      p = parse_real(at, end(), x);
    }
    if (!p || !ends_number(p)) fail(at, expected);
    if (!std::isfinite(x)) fail(at, {expected, ", a finite number"});
    at = last_ = p;
    return x;
  }
  std::int64_t integer(const char* expected, std::int64_t low, std::int64_t high) {
    skip_blanks();
    std::int64_t i = 0;
    const char* const p = parse_integer(at, end(), i);
    if (!p || !ends_number(p) || i < low || i > high) fail(at, expected);
    at = last_ = p;
    return i;
  }
  std::int32_t id() {
    return static_cast<std::int32_t>(integer("an id of 32 bits", std::numeric_limits<std::int32_t>::min(),
                                             std::numeric_limits<std::int32_t>::max()));
  }
  /// A text up to a line end, a comment or the next command, without blanks at its ends.
  std::string_view line_text() {
    while (!at_end() && is_blank(*at)) ++at;
    const char* const from = at;
    while (!at_end() && !is_line_end(*at) && !(left() >= 2 && at[0] == at[1] && (*at == '/' || *at == '$'))) ++at;
    const char* last = at;
    while (last != from && is_blank(last[-1])) --last;
    return {from, static_cast<std::size_t>(last - from)};
  }
};

}  // namespace concino::detail
