// Bodies of text.hpp: text in pictures, in the font concino sans: Latin, Greek, superscripts and mathematical
// characters.
#pragma once

#include <concino/render/detail/image/coverage.hpp>
#include <concino/render/detail/text/font.hpp>
#include <concino/render/detail/text/outline_triangles.hpp>
#include <concino/render/text.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace concino {

namespace detail {

inline void check_text_size(const char* what, double size) {
  if (!(size > 0 && size <= 1e6))
    core::throw_joined<invalid_argument>({what, ": the size of the text must be above 0 and at most 1000000 pixels"});
}

inline void check_text(const char* what, const pixel_position& position, const text_options& o) {
  check_text_size(what, o.size);
  if (!(o.opacity >= 0 && o.opacity <= 1)) core::throw_joined<invalid_argument>({what, ": opacity must be in [0, 1]"});
  if (!std::isfinite(position.x) || !std::isfinite(position.y))
    core::throw_joined<invalid_argument>({what, ": the position is not finite"});
}

/// A text in em, with its position as the origin and y up.
struct text_layout {
  std::vector<std::vector<vec3>> contours;
  std::vector<std::size_t> ends;  // of the contours of each character
  double left = 0, right = 0, low = 0, high = 0, width = 0;

  text_layout(std::string_view text, text_align align, text_level level, double tolerance) {
    const std::vector<char32_t> characters = characters_of(text.data(), text.size());
    const auto lines = static_cast<double>(std::count(characters.begin(), characters.end(), U'\n'));
    const double last = -lines * font_line_height;
    const double shift = level == text_level::baseline ? 0
                         : level == text_level::middle ? -(font_capital_height + last) / 2
                         : level == text_level::top    ? -font_capital_height
                                                       : font_descent - last;
    double y = shift;
    for (auto from = characters.begin();; ++from, y -= font_line_height) {
      const auto to = std::find(from, characters.end(), U'\n');
      add_line(std::vector<char32_t>(from, to), y, align, tolerance);
      if (to == characters.end()) break;
      from = to;
    }
    measure();
  }

 private:
  void add_line(const std::vector<char32_t>& line, double y, text_align align, double tolerance) {
    std::vector<glyph> glyphs;
    double length = 0;
    for (const char32_t c : line) {
      glyphs.push_back(glyph_of(c == U'\t' ? U' ' : c, tolerance));
      length += glyphs.back().advance;
    }
    width = std::max(width, length);
    double x = align == text_align::left ? 0 : align == text_align::middle ? -length / 2 : -length;
    for (glyph& g : glyphs) {
      for (auto& contour : g.contours) {
        for (vec3& p : contour) p += vec3{x, y, 0};
        contours.push_back(std::move(contour));
      }
      ends.push_back(contours.size());
      x += g.advance;
    }
  }

  void measure() {
    if (contours.empty()) return;
    left = low = std::numeric_limits<double>::infinity();
    right = high = -left;
    for (const auto& contour : contours)
      for (const vec3& p : contour) {
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        low = std::min(low, p.y);
        high = std::max(high, p.y);
      }
  }

 public:
  pixel_box box(const pixel_position& p, double size) const {
    return {p.x + left * size, p.y - high * size, p.x + right * size, p.y - low * size};
  }
};

/// How far an interval [low, high], shorter than `length`, has to move to lie in [0, length].
inline double move_inside(double low, double high, double length) {
  return low < 0 ? -low : high > length ? length - high : 0;
}

inline constexpr double text_tolerance = 0.05;  // pixels from the curves

}  // namespace detail

CONCINO_INLINE pixel_box draw_text(image& picture, std::string_view text, const pixel_position& position,
                                   const text_options& options) {
  detail::check_text("draw_text", position, options);
  const detail::text_layout layout(text, options.align, options.level, detail::text_tolerance / options.size);
  double size = options.size;
  pixel_position at = position;
  if (options.keep_inside && picture.width() > 0) {
    const double width = static_cast<double>(picture.width()), height = static_cast<double>(picture.height());
    size = std::min(
        {size, width / std::max(layout.right - layout.left, 1e-9), height / std::max(layout.high - layout.low, 1e-9)});
    at.x += detail::move_inside(at.x + layout.left * size, at.x + layout.right * size, width);
    at.y += detail::move_inside(at.y - layout.high * size, at.y - layout.low * size, height);
  }
  const pixel_box box = layout.box(at, size);
  detail::coverage covered(picture, box);
  std::size_t first = 0;
  for (const std::size_t end : layout.ends) {
    const std::span<const std::vector<vec3>> outlines(layout.contours.data() + first, end - first);
    first = end;
    for (const auto& [a, b, c] : detail::outline_triangles(outlines)) {
      const auto place = [&](const vec3& p) { return pixel_position{at.x + p.x * size, at.y - p.y * size}; };
      covered.add(std::array<pixel_position, 3>{place(a), place(b), place(c)});
    }
  }
  covered.paint(picture, options.color, options.opacity);
  return box;
}

CONCINO_INLINE pixel_box text_box(std::string_view text, const pixel_position& position, const text_options& options) {
  detail::check_text("text_box", position, options);
  return detail::text_layout(text, options.align, options.level, detail::text_tolerance / options.size)
      .box(position, options.size);
}

CONCINO_INLINE double text_width(std::string_view text, double size) {
  detail::check_text_size("text_width", size);
  return detail::text_layout(text, text_align::left, text_level::baseline, 1).width * size;
}

}  // namespace concino
