// The reader of the header of files of the Common Layer Interface, which counts what is skipped.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/detail/slices/cli_cursor.hpp>
#include <concino/io/detail/values/name_runs.hpp>
#include <concino/io/options.hpp>
#include <concino/io/slice_layer.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

class cli_header_reader : protected cli_cursor {
  bool has_encoding_ = false, has_units_ = false;
  std::uint64_t num_user_data_ = 0;
  name_table skipped_;
  std::vector<std::uint64_t> num_skipped_;

 protected:
  slices& out_;
  load_report& report_;
  bool binary_ = false, align_ = false;
  std::optional<std::uint64_t> num_layers_;  // as the header says

  cli_header_reader(std::string_view text, std::string_view name, const concino::progress* progress,
                    load_report& report, slices& out)
      : cli_cursor(text, name, progress), out_(out), report_(report) {}

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

  /// Skips the rest of the line, but no command; counts the name, or what stands there instead of a command.
  void skip_unknown(std::string_view name, const char* from) {
    if (at == from) ++at;
    while (!at_end() && !is_line_end(*at) && !(left() >= 2 && at[0] == '$' && at[1] == '$')) ++at;
    const std::size_t i = skipped_.add(name);
    if (i == num_skipped_.size()) num_skipped_.push_back(0);
    ++num_skipped_[i];
  }

  void report_skipped_commands() {
    for (std::size_t i = 0; i < skipped_.size(); ++i) {
      if (skipped_[i].empty())
        report_.skipped.push_back(core::joined({num_skipped_[i], " parts of the header that are not commands"}));
      else report_.skipped.push_back(core::joined({num_skipped_[i], " unknown commands $$", skipped_[i]}));
    }
    if (num_user_data_) report_.skipped.push_back(core::joined({num_user_data_, " blocks of $$USERDATA"}));
  }

 private:
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
      num_layers_ =
          static_cast<std::uint64_t>(integer("the number of layers", 0, std::numeric_limits<std::int64_t>::max()));
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
};

}  // namespace concino::detail
