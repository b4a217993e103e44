// The reader of STL: triangles by the points of their corners, as text or binary. Equal points become one vert.
#pragma once

#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/stl/stl_format.hpp>
#include <concino/io/detail/values/point_numbers.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <vector>

namespace concino::detail {

inline constexpr polygon_words stl_words{"different points at the corners of a triangle"};

class stl_reader : token_cursor {
  const wanted_mesh& wanted_;
  load_report& report_;
  file_contents& out_;
  point_numbers number_;
  std::uint32_t arity_ = 3;
  std::vector<std::uint64_t> scratch_;

 public:
  stl_reader(const read_context& c, file_contents& out)
      : token_cursor(c.text, c.name, c.progress, 0), wanted_(c.wanted), report_(*c.report), out_(out),
        number_(out.surface.points) {
    out.surface.arity = 3;
  }

  void read(std::string_view text) {
    if (text.empty()) fail(end(), "solid");
    if (is_stl_text(text)) words();
    else binary(text);
  }

 private:
  std::size_t num_polys() const { return out_.surface.verts.size() / 3; }

  void triangle(const char* position, const std::array<vec3, 3>& corners) {
    const std::size_t first = out_.surface.verts.size();
    for (const vec3& p : corners) {
      if (out_.surface.points.size() > max_ids) fail_to_count("verts");
      out_.surface.verts.push_back(number_(p));
    }
    end_checked_poly(*this, position, first, scratch_, wanted_, out_, arity_, stl_words);
    report_progress();
  }

  /// Whether the next word is this one, in upper or lower case; if so, moves behind it.
  bool next_is(std::string_view expected) {
    skip();
    const char* const from = at;
    const std::string_view w = word();
    bool is = w.size() == expected.size();
    for (std::size_t i = 0; is && i < w.size(); ++i) is = (w[i] | 0x20) == expected[i];
    if (!is) at = from;
    return is;
  }
  void expect(const char* keyword) {
    if (!next_is(keyword)) fail(at, keyword);
  }

  void words() {
    std::uint64_t num_named = 0;
    while (next_is("solid")) {
      const std::string name = rest_of_line();
      num_named += !name.empty();
      if (!name.empty() || num_named) out_.objects.change(num_polys(), name);
      while (!next_is("endsolid")) {
        if (!next_is("facet")) fail(at, "facet or endsolid");
        facet();
      }
      skip_line();
    }
    skip_space();
    if (!text_without_padding({at, left()}).empty())
      report_.skipped.push_back(core::joined({"what follows the last endsolid, from line ", line_of(at), " on"}));
    out_.objects.end(num_polys());
  }
  std::string rest_of_line() {
    while (!at_end() && is_blank(*at)) ++at;
    const char* const from = at;
    skip_line();
    const char* to = at;
    while (to != from && is_blank(to[-1])) --to;
    return {from, to};
  }

  void facet() {
    expect("normal");
    for (int k = 0; k < 3; ++k) {  // which follows from the corners, so that it may be anything, such as "-nan(ind)"
      skip();
      if (word().empty()) fail(at, "a component of a normal");
    }
    expect("outer");
    const char* const position = at - 5;
    expect("loop");
    std::array<vec3, 3> corners;
    for (vec3& p : corners) {
      expect("vertex");
      p.x = next_real("the x of a vertex");
      p.y = next_real("the y of a vertex");
      p.z = next_real("the z of a vertex");
    }
    expect("endloop");
    expect("endfacet");
    triangle(position, corners);
  }

  /// Errors of binary files name their first line, as they have no others, and the byte.
  [[noreturn, gnu::noinline, gnu::cold]] void fail_at_byte(core::message expected, core::message found,
                                                           std::uint64_t byte) const {
    fail(begin(), expected, {core::joined(found), " at byte ", byte});
  }

  void binary(std::string_view text) {
    if (text.size() < 84)
      fail_at_byte({"solid, or 80 bytes and the number of triangles"}, {"the end of the file"}, text.size());
    const std::uint32_t n = stl_count(text);
    const std::uint64_t held = (text.size() - 84) / 50;
    if (n > held)
      fail_at_byte({"a number of triangles that fits into the file, 50 bytes each"}, {n, " triangles"}, 80);
    if (const std::uint64_t rest = text.size() - 84 - 50 * std::uint64_t{n})
      report_.skipped.push_back(core::joined({rest, " bytes after the last triangle"}));
    if (text.substr(0, 80).find("COLOR=") != text.npos)
      report_.skipped.push_back("the colour in the first 80 bytes");
    std::vector<std::uint16_t> attributes;
    for (std::uint32_t f = 0; f < n; ++f) {
      const std::size_t first = 84 + 50 * std::size_t{f};
      std::array<vec3, 3> corners;
      for (std::size_t k = 0; k < 9; ++k) {
        const std::size_t byte = first + 12 + 4 * k;
        const float x = std::bit_cast<float>(static_cast<std::uint32_t>(number(text, byte, 4)));
        if (!std::isfinite(x)) fail_at_byte({"a finite coordinate"}, {"another number"}, byte);
        double* const parts[] = {&corners[k / 3].x, &corners[k / 3].y, &corners[k / 3].z};
        *parts[k % 3] = static_cast<double>(x);
      }
      at = begin() + first;
      triangle(begin(), corners);
      if (const auto a = static_cast<std::uint16_t>(number(text, first + 48, 2))) {
        attributes.resize(f);
        attributes.push_back(a);
      }
    }
    if (!attributes.empty())
      std::copy(attributes.begin(), attributes.end(),
                out_.add_property<std::uint16_t>(element_kind::poly, "attribute", num_polys()));
    at = end();
  }
  static std::uint32_t number(std::string_view text, std::size_t byte, std::size_t size) {
    std::uint32_t x = 0;
    for (std::size_t i = size; i-- > 0;) x = x << 8 | static_cast<unsigned char>(text[byte + i]);
    return x;
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  text of an STL file. It is binary if it is as long as its binary header says, has a NUL among its first
///         84 bytes, or does not begin with "solid".
/// Result: its triangles in order. Verts are numbered in the order in which they occur first; corners at equal points
///         are one vert, -0 being equal to 0. The names of solids in text become "object" (std::string) of polys; the
///         two bytes after each triangle in binary files become "attribute" (std::uint16_t) of polys, if one is not 0.
///         Normals are not read: they follow from the corners.
/// Cost:   O(size of the text), expected
/// Errors: parse_error naming the line (in binary files, line 1 and the byte) of a word that does not belong there, a
///         coordinate that is not a finite number, a number of triangles that is larger than the file, a triangle with
///         two corners at the same point, or the end of a file that is cut off.
inline void stl_format::read(const read_context& in, file_contents& out) { detail::stl_reader(in, out).read(in.text); }

}  // namespace concino
