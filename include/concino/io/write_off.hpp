// Writes surfaces as Geomview OFF: text, or binary where that is asked for.
#pragma once

#include <concino/io/write_common.hpp>

#include <bit>
#include <optional>

namespace concino::detail {

/// The integers from 0 to 255 that a reader makes this colour of, if there are any.
inline std::optional<std::array<int, 4>> bytes_of(const rgba& c) {
  std::array<int, 4> bytes{};
  const float parts[] = {c.r, c.g, c.b, c.a};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(parts[i] >= 0 && parts[i] <= 1)) return std::nullopt;
    bytes[i] = static_cast<int>(std::lround(static_cast<double>(parts[i]) * 255));
    if (static_cast<float>(bytes[i] / 255.0) != parts[i]) return std::nullopt;
  }
  return bytes;
}

/// Numbers of a file, as text with blanks before them or as 32 bits, big-endian.
template<class M>
class off_numbers {
  write_context<M>& c_;
  bool binary_;

  void word(std::uint32_t x) {
    for (int shift = 24; shift >= 0; shift -= 8) c_.out << static_cast<char>((x >> shift) & 255);
  }

 public:
  bool rounded = false;  // a coordinate is no float

  off_numbers(write_context<M>& c, bool binary) : c_(c), binary_(binary) {}

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
    rounded = rounded || static_cast<double>(f) != x;
    word(std::bit_cast<std::uint32_t>(f));
  }
  void part(float x) {
    if (binary_) {
      word(std::bit_cast<std::uint32_t>(c_.finite(x)));
      return;
    }
    c_.out << ' ';
    write_part(c_.out, c_.finite(x), true);
  }
  void color(const rgba& x) {
    for (const float p : {x.r, x.g, x.b, x.a}) part(p);
  }
};

template<class M>
void write_off(write_context<M>& c, bool binary) {
  if constexpr (dimension_v<M> == 3) {
    throw_cannot_hold(c.name, ".off", "volumes", ".mesh or .hedra");
  } else {
    const M& m = c.mesh;
    const auto vert_color = property_if_any<element_kind::vert, rgba>(m, "color");
    const auto normal = property_if_any<element_kind::vert, vec3>(m, "normal");
    const auto texture = property_if_any<element_kind::vert, std::array<double, 2>>(m, "texture");
    const auto color = property_if_any<element_kind::poly, rgba>(m, "color");
    const auto label = property_if_any<element_kind::poly, int>(m, "label");
    c.template keep<rgba>(element_kind::vert, "color");
    c.template keep<vec3>(element_kind::vert, "normal");
    c.template keep<std::array<double, 2>>(element_kind::vert, "texture");
    c.template keep<rgba>(element_kind::poly, "color");
    if (!color) c.template keep<int>(element_kind::poly, "label");  // a poly has a colour or the index of one

    off_numbers<M> numbers(c, binary);
    c.out << (texture ? "ST" : "") << (vert_color ? "C" : "") << (normal ? "N" : "") << "OFF";
    if (binary) {
      if (num_verts(m) > 0x7FFFFFFFu || num_polys(m) > 0x7FFFFFFFu) throw_cannot_hold(c.name, "binary .off", "so many elements", ".obj");
      c.out << " BINARY\n";
      for (const std::size_t n : {static_cast<std::size_t>(num_verts(m)), static_cast<std::size_t>(num_polys(m)), std::size_t{0}})
        numbers.integer(static_cast<std::int64_t>(n));
    } else {
      c.out << '\n' << static_cast<std::size_t>(num_verts(m)) << ' ' << static_cast<std::size_t>(num_polys(m)) << " 0\n";
    }
    write_points(
        c, "",
        [&](const vert_t<M>& v) {
          if (normal) {
            const vec3 n = normal[v];
            for (const double x : {n.x, n.y, n.z}) numbers.real(x);
          }
          if (vert_color) numbers.color(vert_color[v]);
          if (texture)
            for (const double x : texture[v]) numbers.real(x);
        },
        [&](const vec3& p) {
          if (!binary) return false;
          for (const double x : {p.x, p.y, p.z}) numbers.real(x);
          return true;
        });
    for (poly_t<M> p : polys(m)) {
      std::int64_t n = 0;
      for ([[maybe_unused]] const vert_t<M>& v : adj_p2v(m, p)) ++n;
      if (binary) numbers.integer(n);
      else c.out << n;
      for (vert_t<M> v : adj_p2v(m, p)) numbers.integer(c.number_of(v));
      if (color) {
        const rgba x = color[p];
        const auto bytes = binary ? std::nullopt : bytes_of(x);
        if (binary) numbers.integer(4);
        if (bytes)
          for (const int i : *bytes) numbers.integer(i);
        else numbers.color(x);
      } else if (label) {
        if (!binary) {
          numbers.integer(label[p]);
        } else {
          numbers.integer(1);
          numbers.part(static_cast<float>(label[p]));
          numbers.rounded = numbers.rounded || static_cast<double>(static_cast<float>(label[p])) != label[p];
        }
      } else if (binary) {
        numbers.integer(0);
      }
      if (!binary) c.out << '\n';
      c.tell();
    }
    if (numbers.rounded) c.report.lost.push_back("binary .off holds floats: coordinates and other numbers were rounded to 32 bits");
  }
}

}  // namespace concino::detail
