// The reader of binary OFF files: 32-bit integers and floats, big-endian as in Geomview, or little-endian.
#pragma once

#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/off/off_format.hpp>
#include <concino/io/text_cursor.hpp>

#include <algorithm>
#include <bit>

namespace concino::detail {

/// The first word of an OFF file, and the form of its numbers.
struct off_header : off_word {
  bool binary = false;
  bool has_poly_colors = true;  // binary files: after each poly the number of components of its colour, and these
  std::uint64_t dimension = 3;

  /// How many numbers each vert has.
  std::uint64_t numbers(std::uint64_t color_size = 4) const {
    return dimension + homogeneous + (normal ? 3 : 0) + (color ? color_size : 0) + (texture ? 2 : 0);
  }
};

inline constexpr polygon_words off_words{"different verts at the corners of a poly"};

class off_binary_reader {
  text_cursor& in_;
  off_header& header_;
  const wanted_mesh& wanted_;
  load_report& report_;
  bool little_ = false;
  const char* line_;  // errors name the line of the word BINARY, as there are no lines after it

 public:
  off_binary_reader(text_cursor& in, off_header& header, const wanted_mesh& wanted, load_report& report)
      : in_(in), header_(header), wanted_(wanted), report_(report), line_(in.at - 2) {}

  void read(surface_arrays& out, file_contents& extra, std::uint32_t& arity) {
    choose_form();
    if (little_)
      report_.notes.push_back("the numbers of the binary file are little-endian; those of OFF are big-endian");
    if (!header_.has_poly_colors)
      report_.notes.push_back(
          "the polys of the binary file do not say how many components their colours have: they have none");
    if (header_.any_dimension) {
      header_.dimension = count("the dimension of the space, at least 1", 1);
      if (header_.dimension == 0) fail(in_.at - 4, "the dimension of the space, at least 1");
    }
    const std::uint64_t verts = count("the number of verts", 4 * header_.numbers());
    const std::uint64_t polys = count("the number of polys", header_.has_poly_colors ? 20 : 16);
    word("the number of edges");
    out.points.reserve(verts);
    for (std::uint64_t i = 0; i < verts; ++i) {
      const vec3 p = point();
      out.points.push_back(p);
      if (header_.normal) {
        const double x = real(), y = real();
        extra.vert_normals.push_back(vec3{x, y, real()});
      }
      if (header_.color) extra.vert_colors.push_back(color(4));
      if (header_.texture) {
        const double s = real();
        extra.vert_textures.push_back(std::array<double, 2>{s, real()});
      }
      in_.report_progress();
    }
    out.verts.reserve(in_.left() / 4 - std::min<std::uint64_t>(in_.left() / 4, 2 * polys));  // if polys have no colours
    std::vector<std::uint64_t> scratch;
    for (std::uint64_t f = 0; f < polys; ++f) {
      poly(out, extra, arity, scratch);
      if (header_.has_poly_colors) attributes(extra, f);
      in_.report_progress();
    }
    if (!in_.at_end()) report_.skipped.push_back(core::joined({in_.left(), " bytes after the last poly"}));
    if (num_odd_)
      report_.skipped.push_back(
          core::joined({num_odd_, " polys with numbers after the corners that are not a colour"}));
    in_.at = in_.end();
  }

 private:
  std::uint64_t num_odd_ = 0;

  [[noreturn, gnu::noinline, gnu::cold]] void fail(const char* position, core::message_piece expected) const {
    in_.fail(line_, {expected},
             {position == in_.end() ? "the end of the file at byte " : "another value at byte ",
              static_cast<std::uint64_t>(position - in_.begin())});
  }

  std::uint32_t word(const char* expected) {
    if (in_.left() < 4) fail(in_.end(), expected);
    std::uint32_t x = 0;
    for (int i = 0; i < 4; ++i) x = (x << 8) | static_cast<unsigned char>(*in_.at++);
    return little_ ? x << 24 | (x & 0xFF00u) << 8 | (x >> 8 & 0xFF00u) | x >> 24 : x;
  }

  /// Finds the byte order, big-endian if the file is valid with it, and whether polys have numbers of components. Files
  /// without these numbers, as pmp writes them, end with the last poly.
  void choose_form() {
    const bool fits_big = fits(false, true), fits_little = !fits_big && fits(true, true);
    header_.has_poly_colors = fits_big || fits_little || (!fits(true, false) && !fits(false, false));
    little_ = header_.has_poly_colors ? fits_little : fits(true, false);
  }

  /// Whether the counts of verts and polys, and of the corners and colours of each poly, stay within the file.
  bool fits(bool little, bool has_colors) {
    const char* const begin = in_.at;
    const std::uint64_t dimension = header_.dimension;
    little_ = little;
    const auto has = [&](std::uint64_t words) { return words <= in_.left() / 4; };
    const auto walk = [&] {
      if (!has(header_.any_dimension ? 4 : 3)) return false;
      if (header_.any_dimension) header_.dimension = word("");
      if (header_.dimension == 0) return false;
      const std::uint64_t verts = word(""), polys = word("");
      word("");
      if (verts > in_.left() / 4 / header_.numbers()) return false;
      in_.at += 4 * verts * header_.numbers();
      for (std::uint64_t f = 0; f < polys; ++f) {
        if (!has(1)) return false;
        const std::uint64_t size = word("");
        if (size < 3 || !has(size + has_colors)) return false;
        in_.at += 4 * size;
        if (!has_colors) continue;
        const std::uint64_t colors = word("");
        if (colors > 4 || !has(colors)) return false;
        in_.at += 4 * colors;
      }
      return has_colors || in_.at_end();
    };
    const bool is = walk();
    in_.at = begin;
    header_.dimension = dimension;
    return is;
  }
  double real() {
    const double x = std::bit_cast<float>(word("a number"));
    if (!std::isfinite(x)) fail(in_.at - 4, "a finite number");
    return x;
  }
  rgba color(std::uint32_t n) {
    rgba c;
    float* const parts[] = {&c.r, &c.g, &c.b, &c.a};
    for (std::uint32_t i = 0; i < n; ++i) *parts[i] = static_cast<float>(real());
    return c;
  }

  /// Reads a number of elements, each of which takes at least `bytes` in the file.
  std::uint64_t count(const char* what, std::uint64_t bytes) {
    const std::uint32_t n = word(what);
    if (n > 0x7FFFFFFFu) fail(in_.at - 4, core::joined({what, ", not negative"}));
    if (n > in_.left() / bytes) fail(in_.at - 4, core::joined({what, ", no more than the rest of the file can hold"}));
    return n;
  }

  vec3 point() {
    double x[3] = {};
    for (std::uint64_t i = 0; i < header_.dimension; ++i) {
      const double c = real();
      if (i < 3) x[i] = c;
    }
    vec3 p{x[0], x[1], x[2]};
    if (header_.homogeneous) {
      const double w = real();
      p = {p.x / w, p.y / w, p.z / w};
      if (!is_finite(p)) fail(in_.at - 4, "a weight w by which x y z can be divided");
    }
    return p;
  }

  void poly(surface_arrays& out, file_contents& extra, std::uint32_t& arity, std::vector<std::uint64_t>& scratch) {
    const std::uint64_t size = count("the number of verts of a poly", 4);
    if (size < 3) fail(in_.at - 4, "a poly of at least three verts");
    const std::size_t first = out.verts.size();
    for (std::uint64_t k = 0; k < size; ++k) {
      const std::uint32_t i = word("the index of a vert");
      if (i >= out.points.size()) fail(in_.at - 4, core::joined({"the index of a vert below ", out.points.size()}));
      const vert_id v{i};
      out.verts.push_back(v);
    }
    end_checked_poly(in_, line_, first, scratch, wanted_, extra, arity, off_words);
  }

  void attributes(file_contents& extra, std::uint64_t f) {
    const std::uint32_t n = word("the number of components of a colour");
    if (n > 4) fail(in_.at - 4, "a colour of at most 4 numbers");
    if (n == 3 || n == 4) {
      extra.poly_colors.resize(f);
      extra.poly_colors.push_back(color(n));
    } else if (n == 1) {
      const double x = real();
      const bool is_index = x == std::floor(x) && x >= -2147483648.0 && x < 2147483648.0;
      if (is_index) {
        extra.poly_labels.resize(f);
        const int label = static_cast<int>(x);
        extra.poly_labels.push_back(label);
      } else {
        ++num_odd_;
      }
    } else {
      for (std::uint32_t i = 0; i < n; ++i) real();
      num_odd_ += n != 0;
    }
  }
};

}  // namespace concino::detail
