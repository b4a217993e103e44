// Bodies of font.hpp: the font of pictures, concino sans: the outlines of Latin, Greek and mathematical characters.
#pragma once

#include <concino/render/detail/text/font.hpp>
#include <concino/render/detail/text/font_table.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace concino::detail {

struct curve_point {
  double x, y;
  bool on_curve, last;
};

inline std::vector<curve_point> decoded_outline(const char* s) {
  const auto digit = [](char c) { return c - '#' - (c > '?') - (c > '\\'); };
  std::vector<curve_point> points;
  int x = 0, y = 0;
  for (; *s; s += 4) {
    const int first = digit(s[0]) * 64 + digit(s[1]), second = digit(s[2]) * 64 + digit(s[3]);
    x += first / 2 - 1024;
    y += second / 2 - 1024;
    points.push_back({x / 1024.0, y / 1024.0, first % 2 == 1, second % 2 == 1});
  }
  return points;
}

/// Appends the points of a quadratic curve, without its first one.
inline void append_curve(std::vector<vec3>& to, vec3 a, const vec3& b, const vec3& c, double tolerance) {
  // The middle of the curve is a quarter of |a - 2 b + c| from its chord, and n pieces are n^2 times nearer.
  const double bend = norm(a - b * 2 + c) / 4;
  const int n = static_cast<int>(std::min(64.0, std::max(1.0, std::ceil(std::sqrt(bend / tolerance)))));
  for (int k = 1; k <= n; ++k) {
    const double t = static_cast<double>(k) / n, s = 1 - t;
    to.push_back(a * (s * s) + b * (2 * s * t) + c * (t * t));
  }
}

inline std::vector<vec3> flattened(const curve_point* first, std::size_t n, double tolerance) {
  const auto at = [&](std::size_t k) { return vec3{first[k % n].x, first[k % n].y, 0}; };
  // The point on the curve at k, or between k - 1 and k: midway between two points off the curve.
  const auto on = [&](std::size_t k) {
    return first[k % n].on_curve             ? at(k)
           : first[(k + n - 1) % n].on_curve ? at(k + n - 1)
                                             : (at(k) + at(k + n - 1)) / 2;
  };
  std::vector<vec3> polygon = {on(0)};
  for (std::size_t k = 0; k < n; ++k) {
    if (!first[k].on_curve) append_curve(polygon, polygon.back(), at(k), on(k + 1), tolerance);
    else if (first[(k + 1) % n].on_curve) polygon.push_back(at(k + 1));
  }
  const auto same = [](const vec3& p, const vec3& q) { return p.x == q.x && p.y == q.y; };
  polygon.erase(std::unique(polygon.begin(), polygon.end(), same), polygon.end());
  while (polygon.size() > 1 && same(polygon.front(), polygon.back())) polygon.pop_back();
  return polygon;
}

CONCINO_INLINE glyph glyph_of(char32_t character, double tolerance) {
  const auto end = std::end(font_entries);
  const auto entry = std::lower_bound(std::begin(font_entries), end, character,
                                      [](const font_entry& e, char32_t c) { return e.character < c; });
  if (entry == end || entry->character != character)
    return {0.6,
            {{{0.05, 0, 0}, {0.55, 0, 0}, {0.55, 0.73, 0}, {0.05, 0.73, 0}},
             {{0.1, 0.05, 0}, {0.1, 0.68, 0}, {0.5, 0.68, 0}, {0.5, 0.05, 0}}}};
  glyph result{entry->advance / 1024.0, {}};
  const std::vector<curve_point> points = decoded_outline(entry->outline);
  for (std::size_t i = 0, first = 0; i < points.size(); ++i) {
    if (!points[i].last) continue;
    auto polygon = flattened(points.data() + first, i + 1 - first, tolerance);
    if (polygon.size() > 2) result.contours.push_back(std::move(polygon));
    first = i + 1;
  }
  return result;
}

CONCINO_INLINE std::vector<char32_t> characters_of(const char* text, std::size_t size) {
  std::vector<char32_t> result;
  const auto byte = [&](std::size_t i) { return i < size ? static_cast<unsigned char>(text[i]) : 0u; };
  for (std::size_t i = 0; i < size;) {
    const unsigned lead = byte(i);
    const std::size_t more = lead < 0x80                   ? 0
                             : lead >= 0xc2 && lead < 0xe0 ? 1
                             : lead >= 0xe0 && lead < 0xf0 ? 2
                             : lead >= 0xf0 && lead < 0xf5 ? 3
                                                           : 4;
    std::uint32_t c = more == 0 ? lead : lead & (0x3fu >> more);
    bool valid = more < 4;
    for (std::size_t k = 1; k <= more && valid; ++k) {
      valid = (byte(i + k) & 0xc0) == 0x80;
      c = c << 6 | (byte(i + k) & 0x3f);
    }
    // Characters that fewer bytes could hold, halves of pairs of UTF-16, and numbers beyond the last character
    if (valid)
      valid =
          !(more == 2 && c < 0x800) && !(more == 3 && (c < 0x10000 || c > 0x10ffff)) && !(c >= 0xd800 && c < 0xe000);
    result.push_back(valid ? static_cast<char32_t>(c) : U'\ufffd');
    i += valid ? more + 1 : 1;
  }
  return result;
}

}  // namespace concino::detail
