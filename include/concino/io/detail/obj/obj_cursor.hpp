// Reads the lines of OBJ files, which go on after a backslash.
#pragma once

#include <concino/io/detail/cells/corners.hpp>
#include <concino/io/text_cursor.hpp>

#include <string>

namespace concino::detail {

class obj_cursor : protected text_cursor {
 protected:
  using text_cursor::text_cursor;

  /// Skips blanks, and line ends after a backslash.
  void blanks() {
    while (at != end()) {
      if (is_blank(*at)) ++at;
      else if (*at != '\\' || !joins_lines()) return;
    }
  }
  bool joins_lines() {
    const char* p = at + 1;
    if (p == end() || !is_line_end(*p)) return false;
    at = p + (*p == '\r' && p + 1 != end() && p[1] == '\n' ? 2 : 1);
    return true;
  }
  bool line_is_over() const { return at == end() || is_line_end(*at) || *at == '#'; }
  void skip_joined_line() {
    while (at != end() && !is_line_end(*at))
      if (*at != '\\' || !joins_lines()) ++at;
  }

  double coordinate(const char* expected) {
    blanks();
    return real(expected);
  }

  /// Converts an index of the file to one that counts from 1. Negative indices count back from the last element read so
  /// far.
  std::uint64_t absolute(const char* position, std::int64_t i, std::uint64_t so_far, std::uint64_t bound,
                         const char* what) const {
    if (i < 0) i += static_cast<std::int64_t>(so_far) + 1;
    if (i < 1 || static_cast<std::uint64_t>(i) > bound)
      fail(position, {"the index of ", what, " from 1 to ", bound < max_ids ? bound : so_far,
                      ", or from -1 (the last one read) back to the first"});
    return static_cast<std::uint64_t>(i);
  }

  /// The rest of the line, without surrounding blanks and without a comment. A comment must follow a blank.
  std::string name_to_end_of_line() {
    std::string name;
    while (at != end() && !is_line_end(*at)) {
      if (*at == '\\' && joins_lines()) {
        name += ' ';
        continue;
      }
      if (*at == '#' && (name.empty() || is_blank(name.back()))) break;
      if (!name.empty() || !is_blank(*at)) name += *at;
      ++at;
    }
    text_cursor::skip_line();
    while (!name.empty() && is_blank(name.back())) name.pop_back();
    return name;
  }
};

}  // namespace concino::detail
