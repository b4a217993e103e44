// The reader of Geomview OFF: verts and polygons of any size, with colours, normals and texture coordinates; as text or
// binary.
#pragma once

#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/off/off_colors.hpp>
#include <concino/io/detail/off/off_cursor.hpp>
#include <concino/io/detail/off/off_format.hpp>

namespace concino::detail {

class off_reader : off_cursor {
  const wanted_mesh& wanted_;
  load_report& report_;
  file_contents& extra_;
  surface_arrays& out_;
  std::uint32_t arity_ = 0;
  std::vector<std::uint64_t> scratch_;
  bool colors_of_polys_ = true;  // the numbers after the corners on a line are a colour
  bool wraps_ = false;                       // polys may continue on the next line
  off_vert_colors vert_colors_;
  std::uint64_t num_extra_ = 0, num_odd_ = 0;

 public:
  off_reader(const read_context& c, file_contents& out)
      : off_cursor(is_off_binary(c.text) ? c.text : text_without_padding(c.text), c.name, c.progress),
        wanted_(c.wanted), report_(*c.report), extra_(out), out_(out.surface),
        vert_colors_(out.vert_colors) {}

  void read() {
    skip_space('#');
    if (at_end()) fail(end(), "OFF");
    header_word();
    if (header_.binary) {
      off_binary_reader(*this, header_, wanted_, report_).read(out_, extra_, arity_);
    } else {
      const auto [verts, polys] = counts();
      read_verts(verts, polys);
      read_polys(polys);
      skip_space('#');
      if (!at_end())
        report_.skipped.push_back(core::joined({"what follows the last poly, from line ", line_of(at), " on"}));
    }
    if (out_.offsets.empty()) out_.arity = arity_;
    if (out_.arity == 0 && out_.offsets.empty()) out_.offsets.push_back(0);
    finish_attributes();
  }

 private:
  void read_verts(std::uint64_t n, std::uint64_t polys) {
    skip_space('#');
    if (n == 0) return;
    choose_layout(n, polys);
    out_.points.reserve(n);
    const bool plain = header_.numbers() == 3 && header_.dimension == 3;
    for (std::uint64_t i = 0; i < n; ++i) {
      skip_space('#');
      vec3 p;
      if (plain) {
        p.x = number("the x of a vert");
        p.y = number("the y of a vert");
        p.z = number("the z of a vert");
      } else {
        p = point();
      }
      out_.points.push_back(p);
      if (!plain) attributes();
      if (per_line_) {
        blanks();
        if (!line_is_over()) extra_numbers();
      }
      report_progress();
    }
  }

  vec3 point() {
    double x[3] = {};
    for (std::uint64_t i = 0; i < header_.dimension; ++i) {
      const double c = number("a coordinate of a vert");
      if (i < 3) x[i] = c;
    }
    vec3 p{x[0], x[1], x[2]};
    if (header_.homogeneous) {
      gap();
      const char* const position = at;
      const double w = real("the weight w of a vert");
      p = {p.x / w, p.y / w, p.z / w};
      if (!is_finite(p)) fail(position, "a weight w by which x y z can be divided");
    }
    return p;
  }

  void attributes() {
    if (header_.normal) {
      vec3 n;
      n.x = number("the x of a normal");
      n.y = number("the y of a normal");
      n.z = number("the z of a normal");
      extra_.vert_normals.push_back(n);
    }
    if (header_.color) vert_color();
    if (header_.texture) {
      const double s = number("the first texture coordinate of a vert");
      extra_.vert_textures.push_back(std::array<double, 2>{s, number("the second texture coordinate of a vert")});
    }
  }

  void add_component(off_color& c) {
    const char* const from = at;
    const double x = real("a component of a colour");
    if (c.size < 4) c.x[c.size] = x;
    ++c.size;
    for (const char* p = from; p != at; ++p) c.whole = c.whole && (is_digit(*p) || *p == '-' || *p == '+');
  }
  void check_bytes(const char* position, const off_color& c) const {
    if (c.whole && (c.largest() > 255 || c.smallest() < 0))
      fail(position, "a colour of integers from 0 to 255, or of reals from 0 to 1");
  }

  void vert_color() {
    gap();
    const char* const position = at;
    off_color c;
    while (c.size < color_size_) {
      gap();
      add_component(c);
    }
    check_bytes(position, c);
    vert_colors_.add(c);
  }

  void extra_numbers() {
    ++num_extra_;
    for (; !line_is_over(); blanks()) real("a number or the end of the line");
  }

  void read_polys(std::uint64_t n) {
    if (n == 0) return;
    skip_space('#');
    if (!per_line_) {
      colors_of_polys_ = lines_left() >= n;
      wraps_ = true;
    }
    for (std::uint64_t f = 0; f < n; ++f) {
      skip_space('#');
      poly(f, n);
      if (colors_of_polys_) {
        blanks();
        if (!line_is_over()) poly_attributes(f);
      }
      if (f == 4095) out_.verts.reserve(expected_corners(n));
      report_progress();
    }
  }

  /// The expected number of corners of n polys, extrapolated from the polys so far; no more than the file can hold.
  std::size_t expected_corners(std::uint64_t n) const {
    const double by_mean = static_cast<double>(out_.verts.size()) / 4096 * static_cast<double>(n) * 1.01;
    return out_.verts.size() + static_cast<std::size_t>(std::min(by_mean, static_cast<double>(left()) / 2));
  }

  void poly(std::uint64_t f, std::uint64_t n) {
    const char* const line = at;
    const std::int64_t size = integer("the number of verts of a poly");
    if (size < 3) fail(line, "a poly of at least three verts");
    const std::size_t first = out_.verts.size();
    const auto bound = out_.points.size();
    for (std::int64_t k = 0; k < size; ++k) {
      blanks();
      if (line_is_over())
        go_on(n - f - 1);
      std::int64_t i = 0;
      const char* const p = parse_integer(at, end(), i);
      if (!p || !ends_token(p, '#') || i < 0 || static_cast<std::uint64_t>(i) >= bound) fail_index();
      at = p;
      const vert_id v{static_cast<std::uint32_t>(i)};
      out_.verts.push_back(v);
    }
    end_checked_poly(*this, line, first, scratch_, wanted_, extra_, arity_, off_words);
  }

  [[noreturn, gnu::noinline, gnu::cold]] void fail_index() const {
    if (out_.points.empty()) fail(at, "no polys, because there are no verts");
    fail(at, {"the index of a vert from 0 to ", out_.points.size() - 1});
  }

  /// Continues a poly on the next line, if enough lines remain for the other polys. Otherwise its line is too short,
  /// which is an error.
  void go_on(std::uint64_t others) {
    if (!wraps_) wraps_ = lines_left() > others;
    if (!wraps_) fail(at, "the index of a vert");
    skip_space('#');
  }

  void poly_attributes(std::uint64_t f) {
    const char* const position = at;
    off_color c;
    for (; !line_is_over(); blanks()) add_component(c);
    if (c.size == 1 && c.whole) {
      if (c.x[0] < std::numeric_limits<int>::min() || c.x[0] > std::numeric_limits<int>::max())
        fail(position, "the index of a colour, an integer of 32 bits");
      extra_.poly_labels.resize(f);
      const int label = static_cast<int>(c.x[0]);
      extra_.poly_labels.push_back(label);
    } else if (c.size == 3 || c.size == 4) {
      check_bytes(position, c);
      extra_.poly_colors.resize(f);
      extra_.poly_colors.push_back(c.color());
    } else {
      ++num_odd_;
    }
  }

  /// Completes the arrays of attributes, as the last polys may have none, and reports what was skipped.
  void finish_attributes() {
    if (!extra_.poly_labels.empty()) extra_.poly_labels.resize(out_.num_polys());
    if (!extra_.poly_colors.empty()) extra_.poly_colors.resize(out_.num_polys());
    if (vert_colors_.rescale())
      report_.notes.push_back(
          "colours of verts: no integer is larger than 1, so they were read as components from 0 to 1");
    const auto skipped = [&](std::uint64_t n, const char* what) {
      if (n) report_.skipped.push_back(core::joined({n, " ", what}));
    };
    skipped(num_extra_, "verts with more numbers than the header says");
    skipped(num_odd_, "polys with numbers after the corners that are not a colour");
    if (header_.dimension > 3)
      report_.skipped.push_back(core::joined({"coordinates beyond the third, of ", header_.dimension}));
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  text of an OFF file: [ST][C][N][4][n]OFF or nothing, also NC for CN, then BINARY and numbers of 32 bits, or
///         text with comments.
/// Result: its verts and polys, in the order of the file. 4OFF: x, y, z are divided by w. nOFF: missing coordinates are
///         0, those beyond the third are reported as skipped. Colours, normals and texture coordinates of verts;
///         colours of polys (white if a poly has none), and indices of colours as labels. Each colour may be integers
///         from 0 to 255 or reals from 0 to 1. If no integer of the verts exceeds 1, these integers are parts from 0 to
///         1 too, as in Geomview. Binary numbers are big-endian. If the file is valid only with little-endian numbers,
///         it is read so, and a note says so. The same for files without the numbers of components of colours.
/// Cost:   O(size of the text)
/// Errors: parse_error naming the line (in binary files, the byte) of a number that is invalid or not finite, of counts
///         that are negative or larger than the file, of an index out of range, of a poly of fewer than three verts or
///         with a vert twice, of a poly that the wanted mesh cannot hold, of w = 0, or of the end of a file that is cut
///         off.
inline void off_format::read(const read_context& in, file_contents& out) { detail::off_reader(in, out).read(); }

}  // namespace concino
