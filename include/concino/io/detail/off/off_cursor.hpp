// Reads the beginning of an OFF file: its first word, its counts, and whether its line breaks matter.
#pragma once

#include <concino/io/detail/off/off_binary.hpp>
#include <concino/io/text_cursor.hpp>

#include <string_view>

namespace concino::detail {

/// Whether the text may be a binary file.
inline bool is_off_binary(std::string_view text) { return text.substr(0, 4096).find("BINARY") != text.npos; }

class off_cursor : protected text_cursor {
 protected:
  off_header header_;
  bool per_line_ = true;          // each vert has a line of its own, which may have additional numbers; else line ends
                                  // are like blanks
  std::uint32_t color_size_ = 4;  // of verts

  using text_cursor::text_cursor;

  bool line_is_over() const { return at == end() || is_line_end(*at) || *at == '#'; }
  void blanks() {
    while (at != end() && is_blank(*at)) ++at;
  }
  /// Moves to the next number of a vert.
  void gap() {
    if (per_line_) blanks();
    else skip_space('#');
  }
  double number(const char* expected) {
    gap();
    return real(expected);
  }

  /// Reads the first word. It may be missing: then the file begins with its counts.
  void header_word() {
    const char* const from = at;
    while (at != end() && !is_space(*at) && *at != '#') ++at;
    std::string_view word{from, static_cast<std::size_t>(at - from)};
    if (word.find_first_not_of("0123456789") == word.npos) {
      at = from;
      return;
    }
    const std::size_t length = header_.parse(word);
    if (length == 0) fail(from, "OFF, preceded only by ST, C, N, 4, n in this order");
    at = from + length;
    blanks();
    const std::string_view rest{at, static_cast<std::size_t>(end() - at)};
    if (rest.starts_with("BINARY")) {
      at += 6;
      blanks();
      if (at == end() || !is_line_end(*at)) fail(at, "the end of the line after BINARY");
      at += *at == '\r' && left() > 1 && at[1] == '\n' ? 2 : 1;
      header_.binary = true;
    } else if (header_.any_dimension) {
      skip_space('#');
      const char* const position = at;
      const std::int64_t n = integer("the dimension of the space, at least 1");
      if (n < 1 || static_cast<std::uint64_t>(n) > left()) fail(position, "the dimension of the space, at least 1");
      header_.dimension = static_cast<std::uint64_t>(n);
    }
  }

  /// Reads a number of elements, each of which takes at least `bytes` in the file.
  std::uint64_t count(const char* what, std::uint64_t bytes) {
    const char* const from = at;
    const std::int64_t n = integer(what);
    if (n < 0) fail(from, {what, ", not negative"});
    if (static_cast<std::uint64_t>(n) > (left() + 1) / bytes)
      fail(from, {what, ", no more than the rest of the file can hold"});
    if (static_cast<std::uint64_t>(n) > max_ids) fail_to_count("elements of one kind");
    return static_cast<std::uint64_t>(n);
  }

  /// Reads the numbers of verts and polys. The number of edges is ignored. It may be missing, if the line ends before
  /// it and the next line is not a single number.
  std::pair<std::uint64_t, std::uint64_t> counts() {
    skip_space('#');
    const std::uint64_t verts = count("the number of verts", 2 * header_.numbers(3));
    skip_space('#');
    const std::uint64_t polys = count("the number of polys", 8);
    blanks();
    if (!line_is_over()) {
      integer("the number of edges or the end of the line");
      return {verts, polys};
    }
    const char* const back = at;
    skip_space('#');
    std::int64_t ignored = 0;
    const char* const past = at_end() ? nullptr : parse_integer(at, end(), ignored);
    if (past && ends_token(past, '#') && header_.numbers() > 1) {
      at = past;
      blanks();
      if (line_is_over()) return {verts, polys};
    }
    at = back;
    return {verts, polys};
  }

  /// The number of lines from here on that are neither blank nor only a comment.
  std::uint64_t lines_left() const {
    std::uint64_t n = 0;
    bool has_content = false, comment = false;
    for (const char* p = at; p != end(); ++p) {
      if (is_line_end(*p)) {
        n += has_content;
        has_content = comment = false;
      } else if (*p == '#') {
        comment = true;
      } else if (!comment && !is_blank(*p)) {
        has_content = true;
      }
    }
    return n + has_content;
  }

  /// Finds out whether each vert has a line of its own, with additional numbers perhaps, or line ends have no meaning.
  /// The first line and the number of lines decide.
  void choose_layout(std::uint64_t verts, std::uint64_t polys) {
    const char* const back = at;
    std::uint64_t numbers = 0;
    for (blanks(); !line_is_over() && numbers <= header_.numbers() + 1; blanks(), ++numbers) word();
    at = back;
    if (numbers == header_.numbers()) return;
    if (header_.color && numbers == header_.numbers(3)) color_size_ = 3;
    else per_line_ = numbers > header_.numbers() ? lines_left() >= verts + polys : lines_left() == verts + polys;
  }
};

}  // namespace concino::detail
