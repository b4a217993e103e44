// The writer of the Common Layer Interface, as text or binary.
#pragma once

#include <concino/core/error.hpp>
#include <concino/io/detail/slices/cli_binary.hpp>
#include <concino/io/detail/slices/cli_lines.hpp>
#include <concino/io/detail/text/characters.hpp>
#include <concino/io/options.hpp>
#include <concino/io/slice_layer.hpp>
#include <concino/io/text_sink.hpp>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace concino::detail {

class cli_writer {
  const slices& s_;
  text_sink& out_;
  std::string_view name_;
  const save_options& options_;
  save_report& report_;
  double units_;
  std::uint64_t num_rounded_ = 0;

 public:
  cli_writer(const slices& s, text_sink& out, std::string_view name, const save_options& options, save_report& report)
      : s_(s), out_(out), name_(name), options_(options), report_(report), units_(s.units) {}

  void write() {
    check();
    if (!options_.binary && units_ != 1 && !units_fit()) {
      units_ = 1;
      report_.notes.push_back(
          "written in units of 1 mm: there are coordinates that are not a multiple of the units that a double can hold");
    }
    write_header();
    if (!options_.binary) out_ << "\n$$GEOMETRYSTART\n";
    for (std::size_t k = 0; k < s_.layers.size(); ++k) {
      write_layer(s_.layers[k]);
      report_progress(options_.progress, static_cast<double>(k + 1) / static_cast<double>(s_.layers.size() + 1),
                      "writing");
    }
    if (!options_.binary) out_ << "$$GEOMETRYEND\n";
    if (num_rounded_ && options_.strict)
      core::throw_joined<unsupported>({name_, ": the file would lose something, and options.strict is set: ",
                                       num_rounded_, " numbers would be rounded to floats"});
    if (num_rounded_) report_.lost.push_back(core::joined({num_rounded_, " numbers were rounded to floats"}));
  }

 private:
  static constexpr slice_lines slice_layer::*kinds_[] = {&slice_layer::outer, &slice_layer::inner, &slice_layer::open,
                                                         &slice_layer::hatches};

  [[noreturn, gnu::noinline, gnu::cold]] void throw_invalid(core::message what) const {
    core::throw_joined<invalid_argument>({name_, ": ", core::joined(what)});
  }

  /// Errors: invalid_argument if the slices cannot be written.
  void check() const {
    if (!(s_.units > 0) || !std::isfinite(s_.units))
      throw_invalid({"the units of the slices must be finite and greater than 0"});
    if (s_.version && (*s_.version < 0 || *s_.version > 1000000))
      throw_invalid({"the version must be from 0 to 1000000, but is ", *s_.version});
    check_text("the date", s_.date);
    for (const slice_label& l : s_.labels) check_text("a label", l.text);
    if (s_.dimension)
      for (const double x : *s_.dimension)
        if (!std::isfinite(x)) throw_invalid({"a number of the dimension is not finite"});
    for (std::size_t k = 0; k < s_.layers.size(); ++k) {
      if (!std::isfinite(s_.layers[k].z)) throw_invalid({"the z of layer ", k, " is not a finite number"});
      for (const auto lines : kinds_) check_lines(s_.layers[k].*lines, k, lines == &slice_layer::hatches);
    }
  }

  void check_text(const char* what, std::string_view text) const {
    if (text.find_first_of("\r\n") != text.npos || text.find("//") != text.npos || text.find("$$") != text.npos)
      throw_invalid({what, " contains a line end, two slashes or $$, which would end it in the file"});
    if (!text.empty() && (is_blank(text.front()) || is_blank(text.back())))
      throw_invalid({what, " begins or ends with a blank, which the file would lose"});
  }

  void check_lines(const slice_lines& lines, std::size_t layer, bool are_hatches) const {
    std::size_t begin = 0;
    for (const std::size_t end : lines.ends) {
      if (end < begin || end > lines.points.size())
        throw_invalid({"the ends of the lines of layer ", layer, " decrease or exceed the number of points"});
      if (are_hatches && (end - begin) % 2 != 0)
        throw_invalid({"a group of hatches of layer ", layer, " has an odd number of points; each hatch has two"});
      begin = end;
    }
    if (begin != lines.points.size() || lines.ids.size() != lines.ends.size())
      throw_invalid({"the lines of layer ", layer, " have points after the last end, or another number of ids"});
    for (const slice_point& p : lines.points)
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
        throw_invalid({"layer ", layer, " has a coordinate that is not a finite number"});
  }

  /// Whether all numbers can be given in the units without rounding.
  bool units_fit() const {
    const auto fits = [&](double x) { return !std::isnan(in_units(x, units_)); };
    for (const slice_layer& layer : s_.layers) {
      if (!fits(layer.z)) return false;
      for (const auto lines : kinds_)
        for (const slice_point& p : (layer.*lines).points)
          if (!fits(p[0]) || !fits(p[1])) return false;
    }
    return true;
  }

  void write_header() {
    out_ << "$$HEADERSTART\n" << (options_.binary ? "$$BINARY\n" : "$$ASCII\n") << "$$UNITS/" << units_ << '\n';
    if (s_.version) out_ << "$$VERSION/" << *s_.version << '\n';
    if (!s_.date.empty()) out_ << "$$DATE/" << s_.date << '\n';
    if (s_.dimension) {
      for (std::size_t i = 0; i < 6; ++i) out_ << (i == 0 ? "$$DIMENSION/" : ",") << (*s_.dimension)[i];
      out_ << '\n';
    }
    out_ << "$$LAYERS/" << s_.layers.size() << '\n';
    for (const slice_label& l : s_.labels) out_ << "$$LABEL/" << l.id << ',' << l.text << '\n';
    out_ << "$$HEADEREND";
  }

  void write_layer(const slice_layer& layer) {
    if (options_.binary) put_code(cli_layer_long);
    else out_ << "$$LAYER/";
    put(layer.z);
    if (!options_.binary) out_ << '\n';
    for (std::size_t kind = 0; kind < 4; ++kind) {
      const slice_lines& lines = layer.*kinds_[kind];
      for (std::size_t i = 0; i < lines.size(); ++i) write_line(lines[i], lines.ids[i], kind);
    }
  }

  /// Kind 0: outer, 1: inner, 2: open, 3: hatches.
  void write_line(std::span<const slice_point> points, std::int32_t id, std::size_t kind) {
    const bool closed = kind < 2 && !points.empty();
    const int direction = kind == 0 ? 1 : kind == 1 ? 0 : 2;
    const std::uint64_t n = kind == 3 ? points.size() / 2 : points.size() + closed;
    if (options_.binary) {
      if (n > 0x7FFFFFFF)
        core::throw_joined<unsupported>({name_, ": a line of ", n, " points; binary files hold at most 2147483647"});
      put_code(kind == 3 ? cli_hatches_long : cli_polyline_long);
      put_word(static_cast<std::uint32_t>(id));
      if (kind != 3) put_word(static_cast<std::uint32_t>(direction));
      put_word(static_cast<std::uint32_t>(n));
    } else {
      out_ << (kind == 3 ? "$$HATCHES/" : "$$POLYLINE/") << id << ',';
      if (kind != 3) out_ << direction << ',';
      out_ << n;
    }
    for (const slice_point& p : points) put_point(p);
    if (closed) put_point(points.front());
    if (!options_.binary) out_ << '\n';
  }

  void put_point(const slice_point& p) {
    for (const double x : p) {
      if (!options_.binary) out_ << ',';
      put(x);
    }
  }

  /// A number of mm, in the units of the file.
  void put(double x) {
    if (!options_.binary) {
      out_ << (units_ == 1 ? x : in_units(x, units_));
      return;
    }
    const double wanted = x / units_;
    const auto f = static_cast<float>(wanted);
    if (!std::isfinite(f))
      core::throw_joined<unsupported>(
          {name_, ": a coordinate is too large for the floats of binary files; use binary = false"});
    num_rounded_ += static_cast<double>(f) * units_ != x;
    put_word(std::bit_cast<std::uint32_t>(f));
  }

  void put_code(std::uint32_t code) {
    const char bytes[] = {static_cast<char>(code), 0};
    out_ << std::string_view(bytes, 2);
  }
  void put_word(std::uint32_t x) {
    const char bytes[] = {static_cast<char>(x), static_cast<char>(x >> 8), static_cast<char>(x >> 16),
                          static_cast<char>(x >> 24)};
    out_ << std::string_view(bytes, 4);
  }
};

}  // namespace concino::detail
