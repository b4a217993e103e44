// The reader of the Common Layer Interface: its header, and geometry as text.
#pragma once

#include <concino/io/detail/slices/cli_binary.hpp>
#include <concino/io/detail/slices/cli_cursor.hpp>
#include <concino/io/detail/slices/cli_lines.hpp>
#include <concino/io/detail/values/name_runs.hpp>
#include <concino/io/options.hpp>
#include <concino/io/slice_layer.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

class cli_reader : cli_cursor {
  slices& out_;
  load_report& report_;
  bool has_encoding_ = false, has_units_ = false, binary_ = false, align_ = false;
  std::uint64_t announced_layers_ = 0;
  bool announces_layers_ = false;
  std::uint64_t num_unclosed_ = 0, num_user_data_ = 0;
  name_table skipped_;
  std::vector<std::uint64_t> num_skipped_;

 public:
  cli_reader(std::string_view text, std::string_view name, const concino::progress* progress, load_report& report,
             slices& out)
      : cli_cursor(text, name, progress), out_(out), report_(report) {}

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
  void read_header() {
    for (;;) {
      skip_blanks();
      const char* const from = at;
      if (at_end()) fail(from, "$$HEADEREND");
      const std::string_view name = command();
      if (name == "HEADEREND") break;
      read_header_command(name, from);
    }
    if (!has_encoding_)
      report_.notes.push_back("the header has neither $$ASCII nor $$BINARY; the geometry was read as text");
    if (!has_units_) report_.notes.push_back("the header has no $$UNITS; coordinates were read as millimetres");
  }

  void read_header_command(std::string_view name, const char* from) {
    if (name == "ASCII" || name == "BINARY") {
      has_encoding_ = true;
      binary_ = name == "BINARY";
    } else if (name == "UNITS") {
      begin_parameters("the units in mm");
      const char* const position = at;
      out_.units = number("the units in mm");
      if (!(out_.units > 0)) fail(position, "units of more than 0 mm");
      has_units_ = true;
    } else if (name == "VERSION") {
      begin_parameters("the version times 100");
      out_.version = integer("the version times 100", 0, 1000000);
    } else if (name == "DATE") {
      begin_parameters("a date");
      out_.date = line_text();
    } else if (name == "LAYERS") {
      begin_parameters("the number of layers");
      announced_layers_ =
          static_cast<std::uint64_t>(integer("the number of layers", 0, std::numeric_limits<std::int64_t>::max()));
      announces_layers_ = true;
    } else if (name == "ALIGN") {
      align_ = true;
    } else if (name == "DIMENSION") {
      read_dimension();
    } else if (name == "LABEL") {
      begin_parameters("an id");
      const std::int32_t label = id();
      comma("a text");
      out_.labels.push_back({label, std::string(line_text())});
    } else if (name == "USERDATA") {
      skip_user_data();
    } else {
      skip_unknown(name, from);
    }
  }

  void read_dimension() {
    begin_parameters("six numbers");
    std::array<double, 6> box{};
    for (std::size_t i = 0; i < 6; ++i) {
      if (i != 0) comma("one of six numbers");
      box[i] = number("one of six numbers");
    }
    out_.dimension = box;
  }

  /// $$USERDATA/name,n, and n bytes; or, where these are not there, a line.
  void skip_user_data() {
    ++num_user_data_;
    const char* const from = at;
    while (!at_end() && *at != ',' && !is_line_end(*at)) ++at;
    std::int64_t n = 0;
    const char* const p = at_end() || *at != ',' ? nullptr : parse_integer(at + 1, end(), n);
    if (p && p != end() && *p == ',' && n >= 0 && n < end() - p) {
      at = p + 1 + n;
    } else {
      at = from;
      skip_line();
    }
  }

  /// Skips the rest of the line, but no command; counts the name, or what stands there instead of a command.
  void skip_unknown(std::string_view name, const char* from) {
    if (at == from) ++at;
    while (!at_end() && !is_line_end(*at) && !(left() >= 2 && at[0] == '$' && at[1] == '$')) ++at;
    const std::size_t i = skipped_.add(name);
    if (i == num_skipped_.size()) num_skipped_.push_back(0);
    ++num_skipped_[i];
  }

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
    if (!announces_layers_) report_.notes.push_back("the header has no $$LAYERS");
    else if (binary_ && n < announced_layers_)  // binary files have no other end
      fail(end(), {announced_layers_, " layers"},
           {n, " layers, and then the end of the file at byte ", end() - begin()});
    else if (n != announced_layers_)
      report_.notes.push_back(
          core::joined({"$$LAYERS announces ", announced_layers_, " layers, but the file has ", n}));
  }

  void report_skipped() {
    for (std::size_t i = 0; i < skipped_.size(); ++i) {
      if (skipped_[i].empty())
        report_.skipped.push_back(core::joined({num_skipped_[i], " parts of the header that are not commands"}));
      else report_.skipped.push_back(core::joined({num_skipped_[i], " unknown commands $$", skipped_[i]}));
    }
    if (num_user_data_) report_.skipped.push_back(core::joined({num_user_data_, " blocks of $$USERDATA"}));
    if (num_unclosed_)
      report_.notes.push_back(
          core::joined({num_unclosed_,
                        " closed contours do not repeat their first point at the end; they are closed all the same"}));
  }
};

}  // namespace concino::detail
