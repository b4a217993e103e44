// A position in the files of TetGen: rows of numbers, one on each line, and comments that begin with #.
#pragma once

#include <concino/io/options.hpp>
#include <concino/io/text_cursor.hpp>

#include <cstdint>
#include <limits>
#include <string_view>

namespace concino::detail {

class tetgen_cursor : public token_cursor {
  std::uint64_t num_longer_ = 0;  // rows with more numbers than the file announces

  void require(const char* what) {
    if (!row_goes_on()) fail(at, what);
  }

 public:
  tetgen_cursor(std::string_view text, std::string_view name, const concino::progress* on_progress)
      : token_cursor(text_without_padding(text), name, on_progress, '#') {}

  /// Moves to the next row. Returns false if there is none.
  bool next_row() {
    report_progress();
    skip_space('#');
    return !at_end();
  }
  /// Moves to the next word of the row. Returns false if there is none.
  bool row_goes_on() {
    while (!at_end() && is_blank(*at)) ++at;
    return !at_end() && !is_line_end(*at) && *at != '#';
  }
  /// Moves to the end of the row.
  void end_row() {
    num_longer_ += row_goes_on();
    skip_line();
  }
  /// Errors: parse_error unless only comments follow.
  void end_file(const char* expected) {
    if (next_row()) fail(at, expected);
  }

  std::int64_t integer_of_row(const char* what) {
    require(what);
    return integer(what, '#');
  }
  double real_of_row(const char* what) {
    require(what);
    return real(what, '#');
  }
  std::uint64_t count_of_row(const char* what, std::uint64_t bytes) {
    require(what);
    return next_count(what, bytes);
  }
  std::uint32_t index_of_row(std::uint64_t bound, const char* what, std::uint32_t first) {
    require(what);
    return next_index(bound, what, first);
  }
  /// A number of the first row, 0 or 1; 0 if the row ends before it.
  bool flag_of_row(const char* what) {
    if (!row_goes_on()) return false;
    const char* const from = at;
    const std::int64_t x = integer(what, '#');
    if (x != 0 && x != 1) fail(from, what);
    return x == 1;
  }
  /// An integer of 32 bits. Some programs write it with a point.
  int marker_of_row(const char* what) {
    require(what);
    const char* const from = at;
    const double x = real(what, '#');
    const int i = static_cast<int>(in_range(x) ? x : 0);
    if (!in_range(x) || static_cast<double>(i) != x) fail(from, what);
    return i;
  }
  /// Reads a number. is_integer becomes false unless it is written as an integer of 32 bits, without a point.
  double attribute_of_row(const char* what, bool& is_integer) {
    require(what);
    std::int64_t i = 0;
    const char* const p = parse_integer(at, end(), i);
    is_integer = is_integer && p && ends_token(p, '#') && i == static_cast<int>(i) && !(i == 0 && *at == '-');
    return real(what, '#');
  }

  void report_longer(load_report& report) const {
    if (num_longer_)
      report.skipped.push_back(core::joined({name(), ": the ends of ", num_longer_,
                                             " rows, which have more numbers than the first row of the list says"}));
  }

 private:
  static bool in_range(double x) {
    return x >= std::numeric_limits<int>::min() && x <= std::numeric_limits<int>::max();
  }
};

}  // namespace concino::detail
