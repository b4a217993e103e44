// The writer of Geomview OFF: surfaces, as text, or as binary on request.
#pragma once

#include <concino/io/detail/off/off_format.hpp>
#include <concino/io/detail/text/write_common.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace concino::detail {

/// Writes numbers, as text with a blank before each, or as 32 bits, big-endian.
class off_numbers {
  write_context& c_;
  bool binary_;

  void word(std::uint32_t x) {
    for (int shift = 24; shift >= 0; shift -= 8) c_.out << static_cast<char>((x >> shift) & 255);
  }

 public:
  bool rounded = false;  // a coordinate cannot be represented as a float

  off_numbers(write_context& c, bool binary) : c_(c), binary_(binary) {}

  void integer(std::int64_t i) {
    if (binary_) word(static_cast<std::uint32_t>(i));
    else c_.out << ' ' << i;
  }
  void real(double x) {
    if (!binary_) {
      c_.out << ' ' << c_.finite(x);
      return;
    }
    const float f = static_cast<float>(c_.finite(x));
    if (!std::isfinite(f))
      c_.throw_cannot_hold("binary .off", {"a number that is too large for floats"}, "text, with binary = false");
    rounded = rounded || static_cast<double>(f) != x;
    word(std::bit_cast<std::uint32_t>(f));
  }
  void part(float x) {
    if (binary_) {
      word(std::bit_cast<std::uint32_t>(c_.finite(x)));
      return;
    }
    c_.out << ' ';
    write_float(c_.out, c_.finite(x), true);
  }
  void color(const rgba& x) {
    for (const float p : {x.r, x.g, x.b, x.a}) part(p);
  }
  void point(const vec3& p) {
    if (!binary_) return write_point(c_.out, p);
    for (const double x : {p.x, p.y, p.z}) real(x);
  }
  void poly_color(const rgba& x) {
    int bytes[4];
    if (binary_) integer(4);
    if (binary_ || !bytes_of(x, bytes)) return color(x);
    for (const int i : bytes) integer(i);
  }
  void poly_label(int label) {
    if (!binary_) return integer(label);
    integer(1);
    const float nearest = std::min(static_cast<float>(label), 0x1.fffffep30f);  // the next float is no label
    part(nearest);
    rounded = rounded || static_cast<double>(nearest) != label;
  }
};

}  // namespace concino::detail

namespace concino {

inline void off_format::write(write_context& c, flat_mesh& m) {
  const bool binary = c.options.binary;
  const flat_values<rgba> vert_color = m.vert_values<rgba>("color");
  const flat_values<vec3> normal = m.vert_values<vec3>("normal");
  const flat_values<std::array<double, 2>> texture = m.vert_values<std::array<double, 2>>("texture");
  const flat_values<rgba> color = m.poly_values<rgba>("color");
  const flat_values<int> label = m.poly_values<int>("label");
  c.declare_stored<rgba>(element_kind::vert, "color");
  c.declare_stored<vec3>(element_kind::vert, "normal");
  c.declare_stored<std::array<double, 2>>(element_kind::vert, "texture");
  c.declare_stored<rgba>(element_kind::poly, "color");
  if (!color) c.declare_stored<int>(element_kind::poly, "label");  // a poly has a colour or the index of one

  detail::off_numbers numbers(c, binary);
  const bool any = !m.points.empty();  // without verts, what they could have would not be read back
  c.out << (any && texture ? "ST" : "") << (any && vert_color ? "C" : "") << (any && normal ? "N" : "") << "OFF";
  const std::size_t vert_count = m.points.size();
  if (binary) {
    if (vert_count > 0x7FFFFFFFu || m.num_polys > 0x7FFFFFFFu)
      c.throw_cannot_hold("binary .off", {"so many elements"}, ".obj");
    c.out << " BINARY\n";
    for (const std::size_t n : {vert_count, m.num_polys, std::size_t{0}}) numbers.integer(static_cast<std::int64_t>(n));
  } else {
    c.out << '\n' << vert_count << ' ' << m.num_polys << " 0\n";
  }
  for (std::size_t v = 0; v < vert_count; ++v) {
    numbers.point(m.points[v]);
    if (normal)
      for (const double x : {normal[v].x, normal[v].y, normal[v].z}) numbers.real(x);
    if (vert_color) numbers.color(vert_color[v]);
    if (texture)
      for (const double x : texture[v]) numbers.real(x);
    if (!binary) c.out << '\n';
    c.report_progress();
  }
  for (std::size_t p = 0; p < m.num_polys; ++p) {
    const std::span<const vert_id> corners = m.poly_verts[p];
    if (binary) numbers.integer(static_cast<std::int64_t>(corners.size()));
    else c.out << corners.size();
    for (const vert_id v : corners) numbers.integer(v.raw());
    if (color) numbers.poly_color(color[p]);
    else if (label) numbers.poly_label(label[p]);
    else if (binary) numbers.integer(0);
    if (!binary) c.out << '\n';
    c.report_progress();
  }
  if (numbers.rounded)
    c.report.lost.push_back("binary .off holds floats: coordinates and other numbers were rounded to 32 bits");
}

}  // namespace concino
