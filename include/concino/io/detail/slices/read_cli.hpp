// The reader of the Common Layer Interface: its geometry as text, and the whole of a file.
#pragma once

#include <concino/io/detail/slices/cli_binary.hpp>
#include <concino/io/detail/slices/cli_header.hpp>
#include <concino/io/detail/slices/cli_lines.hpp>
#include <concino/io/options.hpp>
#include <concino/io/slice_layer.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace concino::detail {

class cli_reader : cli_header_reader {
  std::uint64_t num_unclosed_ = 0;

 public:
  cli_reader(std::string_view text, std::string_view name, const concino::progress* progress, load_report& report,
             slices& out)
      : cli_header_reader(text, name, progress, report, out) {}

  void read() {
    skip_blanks();
    const char* const from = at;
    if (command() != "HEADERSTART") fail(from, "$$HEADERSTART");
    read_header();
    if (binary_) num_unclosed_ = cli_binary_reader(*this, out_, report_, align_).read();
    else read_geometry();
    check_layers();
    report_skipped();
  }

 private:
  void read_geometry() {
    skip_blanks();
    const char* from = at;
    if (command() != "GEOMETRYSTART") {
      at = from;
      if (command() != "LAYER") fail(from, "$$GEOMETRYSTART");
      at = from;
      report_.notes.push_back("the geometry begins without $$GEOMETRYSTART");
    }
    for (;;) {
      skip_blanks();
      from = at;
      const std::string_view name = command();
      if (name == "GEOMETRYEND" || name == "END") break;
      if (name.empty()) fail(from, "$$ and a command, or $$GEOMETRYEND");
      read_command(name, from);
      report_progress();
    }
    for (skip_blanks(); !at_end(); skip_blanks()) {
      from = at;
      if (command() != "GEOMETRYEND" && word().size() != 0) {
        report_.skipped.push_back(
            core::joined({"what follows the end of the geometry, from line ", line_of(from), " on"}));
        break;
      }
    }
  }

  void read_command(std::string_view name, const char* from) {
    if (name == "LAYER") {
      begin_parameters("the z of a layer");
      const char* const position = at;
      begin_layer(out_, finite(position, number("the z of a layer") * out_.units));
    } else if (name == "POLYLINE") {
      read_polyline(from);
    } else if (name == "HATCHES") {
      read_hatches(from);
    } else {
      return skip_unknown(name, from);
    }
    if (next_parameter()) {  // some writers end lists with a comma
      skip_blanks();
      if (!at_end() && *at != '$') fail(at, "the end of the command, as all its numbers are there");
    }
  }

  slice_layer& current_layer(const char* from) {
    if (out_.layers.empty()) fail(from, "$$LAYER before the first line of a layer");
    return out_.layers.back();
  }

  void read_polyline(const char* from) {
    slice_layer& layer = current_layer(from);
    begin_parameters("an id");
    const std::int32_t line = id();
    comma("a direction");
    const std::int64_t direction = integer("a direction: 0 for inner, 1 for outer, 2 for open lines", 0, 2);
    comma("the number of points");
    const std::uint64_t n = count("the number of points");
    slice_lines& to = direction == 0 ? layer.inner : direction == 1 ? layer.outer : layer.open;
    read_points(to, n, "points");
    num_unclosed_ += !end_line(to, line, direction != 2);
  }

  void read_hatches(const char* from) {
    slice_layer& layer = current_layer(from);
    begin_parameters("an id");
    const std::int32_t group = id();
    comma("the number of hatches");
    const std::uint64_t n = count("the number of hatches");
    read_points(layer.hatches, 2 * n, "ends of hatches");
    end_line(layer.hatches, group, false);
  }

  std::uint64_t count(const char* expected) {
    return static_cast<std::uint64_t>(integer(expected, 0, std::numeric_limits<std::int64_t>::max() / 8));
  }

  void read_points(slice_lines& to, std::uint64_t n, const char* what) {
    const std::uint64_t room = std::min(n, left() / 4 + 1);  // a point takes four characters or more
    if (to.points.capacity() - to.points.size() < room)
      to.points.reserve(std::max(to.points.size() + room, 2 * to.points.size()));
    for (std::uint64_t i = 0; i < n; ++i) {
      slice_point p;
      for (double& x : p) {
        if (!next_parameter())
          fail(last_, {2 * n, " coordinates of ", n, " ", what},
               {2 * i + (&x != p.data()), ", and then ", found_at(last_)});
        const char* const position = at;
        x = finite(position, number("a coordinate") * out_.units);
      }
      to.points.push_back(p);
    }
  }

  double finite(const char* position, double x) const {
    if (!std::isfinite(x)) fail(position, "a number that is finite in mm");
    return x;
  }

  void check_layers() {
    const std::uint64_t n = out_.layers.size();
    if (!num_layers_) report_.notes.push_back("the header has no $$LAYERS");
    else if (binary_ && n < *num_layers_)  // binary files have no other end
      fail(end(), {*num_layers_, " layers"},
           {n, " layers, and then the end of the file at byte ", end() - begin()});
    else if (n != *num_layers_)
      report_.notes.push_back(
          core::joined({"$$LAYERS states ", *num_layers_, " layers, but the file has ", n}));
  }

  void report_skipped() {
    report_skipped_commands();
    if (num_unclosed_)
      report_.notes.push_back(
          core::joined({num_unclosed_,
                        " closed contours do not repeat their first point at the end; they are closed all the same"}));
  }
};

}  // namespace concino::detail
