// The font of pictures, concino sans: the outlines of Latin, Greek and mathematical characters.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <cstddef>
#include <vector>

namespace concino::detail {

/// Heights above the baseline, in em.
inline constexpr double font_capital_height = 0.729, font_descent = 0.236, font_line_height = 1.2;

/// A character as polygons, in em, x to the right and y up from the baseline; the outer ones are counter-clockwise,
/// holes clockwise.
struct glyph {
  double advance = 0;  // from its origin to that of the next character
  std::vector<std::vector<vec3>> contours;
};

/// The character, or an empty box if the font does not have it. No polygon is farther than `tolerance` em from its
/// curve.
glyph glyph_of(char32_t character, double tolerance);

/// The characters of a text in UTF-8. A byte that does not belong to one is the replacement character, U+FFFD.
std::vector<char32_t> characters_of(const char* text, std::size_t size);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/text/font.ipp>
#endif
