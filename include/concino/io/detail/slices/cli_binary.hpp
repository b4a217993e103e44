// The reader of binary geometry in files of the Common Layer Interface: commands of 16 bits, each with integers or
// floats.
#pragma once

#include <concino/io/detail/slices/cli_lines.hpp>
#include <concino/io/options.hpp>
#include <concino/io/slice_layer.hpp>
#include <concino/io/text_cursor.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace concino::detail {

/// The codes of binary commands.
enum cli_code : std::uint32_t {
  cli_layer_long = 127,
  cli_layer_short = 128,
  cli_polyline_short = 129,
  cli_polyline_long = 130,
  cli_hatches_short = 131,
  cli_hatches_long = 132
};

class cli_binary_reader {
  text_cursor& in_;
  slices& out_;
  load_report& report_;
  const char* line_;   // errors name the line of $$HEADEREND, as there are no lines after it
  const char* begin_;  // of the first command
  bool aligned_, aligned_code_ = false, big_ = false;

 public:
  cli_binary_reader(text_cursor& in, slices& out, load_report& report, bool aligned)
      : in_(in), out_(out), report_(report), line_(in.at - 1), begin_(in.at), aligned_(aligned) {}

  /// Reads all commands. Result: the number of closed contours that do not repeat their first point.
  std::uint64_t read() {
    find_first_command();
    if (aligned_ && !fits() && fits(true)) {
      aligned_code_ = true;
      report_.notes.push_back("commands are aligned after their codes; those of CLI are aligned at their ends");
    }
    std::uint64_t num_unclosed = 0;
    in_.at = begin_;
    while (!in_.at_end()) {
      num_unclosed += !read_command();
      in_.report_progress();
    }
    return num_unclosed;
  }

 private:
  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* position, core::message expected) const {
    in_.fail(line_, expected,
             {position == in_.end() ? "the end of the file at byte " : "something else at byte ",
              static_cast<std::uint64_t>(position - in_.begin())});
  }

  bool is_layer(const char* p) const {
    if (in_.end() - p < 2) return false;
    const std::uint32_t code = load(p, 2);
    return code == cli_layer_long || code == cli_layer_short;
  }

  /// Finds the first command, which begins a layer: after a line end, if there is one, and in the byte order of the
  /// file.
  void find_first_command() {
    if (in_.at_end()) return;
    const char* after_line = begin_;
    while (after_line != in_.end() && after_line - begin_ < 2 && is_line_end(*after_line)) ++after_line;
    for (const bool big : {false, true})
      for (const char* const p : {begin_, after_line}) {
        big_ = big;
        if (!is_layer(p)) continue;
        if (p != begin_) report_.notes.push_back("a line end follows $$HEADEREND; binary files of CLI have none");
        if (big)
          report_.notes.push_back("the numbers of the binary file are big-endian; those of CLI are little-endian");
        begin_ = p;
        return;
      }
    fail(begin_, {"a layer (command 127 or 128)"});
  }

  /// An unsigned number of `bytes` bytes.
  std::uint32_t load(const char* p, std::size_t bytes) const {
    std::uint32_t x = 0;
    for (std::size_t i = 0; i < bytes; ++i)
      x |= static_cast<std::uint32_t>(static_cast<unsigned char>(p[big_ ? bytes - 1 - i : i])) << 8 * i;
    return x;
  }

  std::uint64_t padding(const char* p) const { return aligned_ ? -static_cast<std::uint64_t>(p - begin_) & 3 : 0; }

  void skip_padding() { in_.at += std::min(padding(in_.at), in_.left()); }

  /// Whether the file consists of whole commands, with alignment after their codes or at their ends.
  bool fits(bool aligned_code = false) const {
    for (const char* p = begin_; p != in_.end();) {
      const auto left = [&] { return static_cast<std::uint64_t>(in_.end() - p); };
      if (left() < 2) return false;
      const std::uint32_t code = load(p, 2);
      if (code < cli_layer_long || code > cli_hatches_long) return false;
      const bool is_long = has_long_numbers(code);
      const std::uint64_t size = is_long ? 4 : 2;
      p += 2;
      if (aligned_code) p += std::min(padding(p), left());
      std::uint64_t bytes = size;
      if (code >= cli_polyline_short) {
        const bool is_polyline = code <= cli_polyline_long;
        const std::uint64_t before = is_polyline ? 3 : 2;
        if (left() < before * size) return false;
        bytes = before * size + std::uint64_t{load(p + (before - 1) * size, size)} * (is_polyline ? 2 : 4) * size;
      }
      if (left() < bytes) return false;
      p += bytes;
      if (!aligned_code) p += std::min(padding(p), left());
    }
    return true;
  }

  static bool has_long_numbers(std::uint32_t code) {
    return code == cli_layer_long || code == cli_polyline_long || code == cli_hatches_long;
  }

  /// Errors: parse_error if fewer bytes are left.
  void need(std::uint64_t bytes, const char* what) const {
    if (in_.left() < bytes) fail(in_.end(), {what, " at byte ", in_.at - in_.begin()});
  }
  std::uint32_t next(std::size_t bytes, const char* what) {
    need(bytes, what);
    const std::uint32_t x = load(in_.at, bytes);
    in_.at += bytes;
    return x;
  }
  /// A coordinate in mm. Needs: as many bytes.
  double coordinate(bool is_long) {
    const char* const position = in_.at;
    const std::uint32_t bits = load(position, is_long ? 4 : 2);
    in_.at += is_long ? 4 : 2;
    const double x =
        (is_long ? static_cast<double>(std::bit_cast<float>(bits)) : static_cast<double>(bits)) * out_.units;
    if (!std::isfinite(x)) fail(position, {"a coordinate that is finite in mm"});
    return x;
  }

  bool read_command() {
    const char* const from = in_.at;
    const std::uint32_t code = next(2, "a command");
    if (code < cli_layer_long || code > cli_hatches_long) fail(from, {"a command from 127 to 132"});
    if (aligned_code_) skip_padding();
    const bool is_long = has_long_numbers(code);
    bool closed = true;
    if (code <= cli_layer_short) {
      need(is_long ? 4 : 2, "the z of a layer");
      begin_layer(out_, coordinate(is_long));
    } else {
      closed = read_lines(code <= cli_polyline_long, is_long);
    }
    if (!aligned_code_) skip_padding();
    return closed;
  }

  bool read_lines(bool is_polyline, bool is_long) {
    const std::size_t size = is_long ? 4 : 2;
    slice_layer& layer = out_.layers.back();  // the first command is a layer
    const auto id = static_cast<std::int32_t>(next(size, "an id"));
    const char* const position = in_.at;
    const std::uint32_t direction = is_polyline ? next(size, "a direction") : 2;
    if (direction > 2) fail(position, {"a direction: 0 for inner, 1 for outer, 2 for open lines"});
    const char* const count_position = in_.at;
    std::uint64_t n = next(size, is_polyline ? "the number of points" : "the number of hatches");
    if (!is_polyline) n *= 2;
    if (n > in_.left() / (2 * size))
      fail(count_position,
           {"at most ", in_.left() / (2 * size), " points, as many as the rest of the file can hold, instead of ", n});
    slice_lines& lines = !is_polyline     ? layer.hatches
                         : direction == 0 ? layer.inner
                         : direction == 1 ? layer.outer
                                          : layer.open;
    if (lines.points.capacity() - lines.points.size() < n)
      lines.points.reserve(std::max(lines.points.size() + n, 2 * lines.points.size()));
    for (std::uint64_t i = 0; i < n; ++i) {
      const double x = coordinate(is_long);
      lines.points.push_back({x, coordinate(is_long)});
    }
    return end_line(lines, id, is_polyline && direction != 2);
  }
};

}  // namespace concino::detail
