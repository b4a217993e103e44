// The reader of .csv: points of a polyline, one in each line.
#pragma once

#include <concino/io/detail/skeleton/skeleton_reader.hpp>
#include <concino/io/detail/text/characters.hpp>

#include <cmath>
#include <cstdint>

namespace concino::detail {

class csv_reader : skeleton_reader {
  std::uint64_t num_more_ = 0;

 public:
  using skeleton_reader::skeleton_reader;

  void read() {
    skip();
    double unused = 0;
    if (!at_end() && (is_letter(*at) || *at == '"' || *at == '#') && !parse_real(at, end(), unused)) {
      skip_line();
      report_.skipped.push_back("the first line, which has no numbers");
    }
    for (skip(); !at_end(); skip()) {
      read_line();
      report_progress();
    }
    if (out_.points.empty()) fail(end(), "x y z of a point");
    if (num_more_) report_.skipped.push_back(core::joined({"a fourth number of ", num_more_, " points"}));
  }

 private:
  /// Moves to the next number of the line. Result: false at the end of the line.
  bool next_number() {
    while (!at_end() && (is_blank(*at) || *at == ',' || *at == ';')) ++at;
    return !at_end() && !is_line_end(*at);
  }
  double number(const char* expected) {
    double x = 0;
    const char* const p = parse_real(at, end(), x);
    if (!p || !(p == end() || is_space(*p) || *p == ',' || *p == ';')) fail(at, expected);
    if (!std::isfinite(x)) fail(at, {expected, ", a finite number"});
    at = p;
    return x;
  }
  void read_line() {
    if (out_.points.size() == max_count) fail_to_count("verts");
    double x[3];
    for (double& c : x) {
      if (!next_number()) fail(at, "x y z of a point in one line");
      c = number("a coordinate of a point");
    }
    out_.points.push_back({x[0], x[1], x[2]});
    if (out_.points.size() > 1) add_edge(out_.points.size() - 2, out_.points.size() - 1);
    if (next_number()) {
      number("a number after x y z");
      ++num_more_;
    }
    if (next_number()) fail(at, "the end of the line after four numbers");
  }
};

}  // namespace concino::detail
