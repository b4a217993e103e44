// Finds the sections of MEDIT files in ASCII, and reads their numbers.
#pragma once

#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/medit/medit_sections.hpp>
#include <concino/io/text_cursor.hpp>

namespace concino::detail {

class medit_text : protected token_cursor {
  load_report& report_;
  std::uint64_t num_rounded_ = 0;  // references that are not integers
  const char* first_rounded_ = nullptr;

 protected:
  int dimension_ = 0;
  bool ended_ = false;
  bool has_ordering_ = false;  // a section that lists the order of nodes in elements

  explicit medit_text(const read_context& c)
      : token_cursor(text_without_padding(c.text), c.name, c.progress, '#'), report_(*c.report) {}

  void begin_file() {
    skip();
    if (at_end()) fail(end(), "MeshVersionFormatted");
    const char* const from = at;
    if (word() != "MeshVersionFormatted") fail(from, "MeshVersionFormatted (MEDIT in ASCII)");
    next_integer("the version of the format, an integer");
  }

  /// Finds the next section of the table, or Vertices, and moves to its first row. Returns false if there is none.
  bool next_section(medit_section_header& header) {
    for (skip(); !at_end(); skip()) {
      const char* const from = at;
      const std::string_view keyword = is_letter(*at) ? word() : std::string_view{};
      if (keyword == "End") {
        ended_ = true;
        return false;
      }
      if (keyword.empty()) fail(from, "a keyword, such as Tetrahedra or End");
      if (keyword == "Dimension") dimension();
      else if (find(keyword, from, header)) return true;
    }
    return false;
  }

  /// Moves to the next word that begins with a letter.
  void skip_rows() {
    for (bool after_space = true; !at_end(); ++at) {
      if (*at == comment) {
        skip_line();
        if (at_end()) return;
        after_space = true;
      } else if (is_space(*at)) {
        after_space = true;
        report_progress();
      } else {
        if (after_space && is_letter(*at)) return;
        after_space = false;
      }
    }
  }

  std::string describe_position(const char* p) const { return core::joined({"on line ", line_of(p)}); }
  const char* position() {
    skip();
    return at;
  }
  std::uint32_t index(std::uint64_t bound, const char* what) { return next_index(bound, what); }
  double coordinate(const char* what) { return next_real(what); }
  /// How many rows of a section there is room for, of so many numbers each.
  std::size_t room_for(const medit_section_header& header, std::uint64_t numbers) const {
    return reservable(header.count, 2 * numbers);
  }

  int reference(const char* what) {
    skip();
    const char* const from = at;
    std::int64_t label = 0;
    const char* const p = parse_integer(at, end(), label);
    if (p && ends_token(p, comment)) at = p;
    else label = real_reference(what);
    if (label < std::numeric_limits<int>::min() || label > std::numeric_limits<int>::max())
      fail(from, {what, " of 32 bits"});
    return static_cast<int>(label);
  }

  void end_file() {
    if (!ended_) report_.notes.push_back("the file has no End: it may be cut off");
  }
  void report_rounded() {
    if (num_rounded_)
      report_.notes.push_back(
          core::joined({num_rounded_, " references are not integers and were rounded, the first on line ",
                        line_of(first_rounded_)}));
  }

 private:
  void dimension() {
    skip();
    const char* const number = at;
    dimension_ = static_cast<int>(std::clamp<std::int64_t>(next_integer("the dimension, 2 or 3"), 0, 4));
    if (dimension_ != 2 && dimension_ != 3) fail(number, "the dimension, 2 or 3");
  }

  /// Finds the section of a keyword and reads the number of its rows. Skips one that is unknown, and returns false.
  bool find(std::string_view keyword, const char* from, medit_section_header& header) {
    header = {};
    if (keyword == "Vertices") {
      if (dimension_ == 0) fail(from, "Dimension before Vertices");
      header.count = next_count("the number of vertices", static_cast<std::uint64_t>(2 * dimension_ + 2));
      header.at = at;
      return true;
    }
    header.section = find_medit_section(&medit_section::keyword, keyword);
    if (header.section) {
      header.count = next_count("the number of elements", 2 * header.section->num_indices() + 2);
      header.at = at;
      return true;
    }
    has_ordering_ = has_ordering_ || is_medit_ordering(keyword);
    skip();
    std::int64_t n = 0;
    parse_integer(at, end(), n);  // most sections begin with the number of their rows
    report_.skipped.push_back(n > 0 ? core::joined({"section ", keyword.substr(0, 40), ", ", n, " rows"})
                                    : core::joined({"section ", keyword.substr(0, 40)}));
    skip_rows();
    return false;
  }

  /// Reads a reference that is a real number, as some programs write them. If it exceeds 32 bits, the result does too.
  std::int64_t real_reference(const char* what) {
    const char* const from = at;
    const double x = std::clamp(real(what, comment), -0x1p40, 0x1p40), rounded = std::round(x);
    if (x != rounded && num_rounded_++ == 0) first_rounded_ = from;
    return static_cast<std::int64_t>(rounded);
  }
};

}  // namespace concino::detail
