// Writes surfaces as Geomview OFF: text, or binary where that is asked for.
#pragma once

#include <concino/io/detail/write_common.hpp>

#include <bit>

namespace concino::detail {

/// The integers from 0 to 255 that a reader makes this colour of; false where there are none.
inline bool bytes_of(const rgba& c, int (&bytes)[4]) {
  const float parts[] = {c.r, c.g, c.b, c.a};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(parts[i] >= 0 && parts[i] <= 1)) return false;
    bytes[i] = static_cast<int>(std::lround(static_cast<double>(parts[i]) * 255));
    if (static_cast<float>(bytes[i] / 255.0) != parts[i]) return false;
  }
  return true;
}

/// Numbers of a file, as text with blanks before them or as 32 bits, big-endian.
class off_numbers {
  write_state& c_;
  bool binary_;

  void word(std::uint32_t x) {
    for (int shift = 24; shift >= 0; shift -= 8) c_.out << static_cast<char>((x >> shift) & 255);
  }

 public:
  bool rounded = false;  // a coordinate is no float

  off_numbers(write_state& c, bool binary) : c_(c), binary_(binary) {}

  [[gnu::noinline]] void integer(std::int64_t i) {
    if (binary_) word(static_cast<std::uint32_t>(i));
    else c_.out << ' ' << i;
  }
  [[gnu::noinline]] void real(double x) {
    if (!binary_) {
      c_.out << ' ' << c_.finite(x);
      return;
    }
    const float f = static_cast<float>(c_.finite(x));
    rounded = rounded || static_cast<double>(f) != x;
    word(std::bit_cast<std::uint32_t>(f));
  }
  [[gnu::noinline]] void part(float x) {
    if (binary_) {
      word(std::bit_cast<std::uint32_t>(c_.finite(x)));
      return;
    }
    c_.out << ' ';
    write_part(c_.out, c_.finite(x), true);
  }
  [[gnu::noinline]] void color(const rgba& x) {
    for (const float p : {x.r, x.g, x.b, x.a}) part(p);
  }
  void point(const vec3& p) {
    if (!binary_) return write_point(c_.out, p);
    for (const double x : {p.x, p.y, p.z}) real(x);
  }
  [[gnu::noinline]] void poly_color(const rgba& x) {
    int bytes[4];
    if (binary_) integer(4);
    if (binary_ || !bytes_of(x, bytes)) return color(x);
    for (const int i : bytes) integer(i);
  }
  [[gnu::noinline]] void poly_label(int label) {
    if (!binary_) return integer(label);
    integer(1);
    part(static_cast<float>(label));
    rounded = rounded || static_cast<double>(static_cast<float>(label)) != label;
  }
};

template<class M>
void write_off(write_context<M>& c, bool binary) {
  if constexpr (dimension_v<M> == 3) {  // the format holds surfaces only
    c.cannot_hold(".off", {"volumes"}, ".mesh or .hedra");
  } else {
    const M& m = c.mesh;
    const rgba* const vert_color = values_if_any<rgba>(m, element_kind::vert, "color");
    const vec3* const normal = values_if_any<vec3>(m, element_kind::vert, "normal");
    const auto* const texture = values_if_any<std::array<double, 2>>(m, element_kind::vert, "texture");
    const rgba* const color = values_if_any<rgba>(m, element_kind::poly, "color");
    const int* const label = values_if_any<int>(m, element_kind::poly, "label");
    c.keep(element_kind::vert, "color", typeid(rgba));
    c.keep(element_kind::vert, "normal", typeid(vec3));
    c.keep(element_kind::vert, "texture", typeid(std::array<double, 2>));
    c.keep(element_kind::poly, "color", typeid(rgba));
    if (!color) c.keep(element_kind::poly, "label", typeid(int));  // a poly has a colour or the index of one

    off_numbers numbers(c, binary);
    c.out << (texture ? "ST" : "") << (vert_color ? "C" : "") << (normal ? "N" : "") << "OFF";
    if (binary) {
      if (num_verts(m) > 0x7FFFFFFFu || num_polys(m) > 0x7FFFFFFFu) c.cannot_hold("binary .off", {"so many elements"}, ".obj");
      c.out << " BINARY\n";
      for (const std::size_t n : {num_verts(m), num_polys(m), std::size_t{0}})
        numbers.integer(static_cast<std::int64_t>(n));
    } else {
      c.out << '\n' << num_verts(m) << ' ' << num_polys(m) << " 0\n";
    }
    for (const vert_t<M> v : verts(m)) {
      numbers.point(c.next_point(v));
      const std::size_t i = index_of(m, v);
      if (normal)
        for (const double x : {normal[i].x, normal[i].y, normal[i].z}) numbers.real(x);
      if (vert_color) numbers.color(vert_color[i]);
      if (texture)
        for (const double x : texture[i]) numbers.real(x);
      if (!binary) c.out << '\n';
      c.tell();
    }
    for (const poly_t<M> p : polys(m)) {
      std::int64_t n = 0;
      for ([[maybe_unused]] const vert_t<M>& v : adj_p2v(m, p)) ++n;
      if (binary) numbers.integer(n);
      else c.out << n;
      for (const vert_t<M> v : adj_p2v(m, p)) numbers.integer(c.number_of(v));
      if (color) numbers.poly_color(color[index_of(m, p)]);
      else if (label) numbers.poly_label(label[index_of(m, p)]);
      else if (binary) numbers.integer(0);
      if (!binary) c.out << '\n';
      c.tell();
    }
    if (numbers.rounded) c.report.lost.push_back("binary .off holds floats: coordinates and other numbers were rounded to 32 bits");
  }
}

}  // namespace concino::detail
