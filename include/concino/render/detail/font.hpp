// The font of pictures, concino sans: the outlines of Latin, Greek and mathematical characters.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// A character in the table of the font. Its outline is a string of four characters for each point, 64 different ones in all: they are two
/// numbers from 0 to 4095, of two digits each, those after '#' without '?' and '\'. Half of a number, minus 1024, is the distance from the
/// last point, in 1/1024 of the em. The last bit of the first number says whether the point is on the curve, that of the second whether it
/// ends its contour.
struct font_entry {
  std::uint32_t character;
  std::uint16_t advance;
  const char* outline;
};

/// Heights above the baseline, in em.
inline constexpr double font_capital_height = 0.729, font_ascent = 0.928, font_descent = 0.236, font_line_height = 1.2;

/// A character as polygons, in em, x to the right and y up from the baseline; the outer ones are counter-clockwise, holes clockwise.
struct glyph {
  double advance = 0;  // from its origin to that of the next character
  std::vector<std::vector<vec3>> contours;
};

/// The character, or an empty box if the font does not have it. No polygon is farther than `tolerance` em from its curve.
glyph glyph_of(char32_t character, double tolerance);

/// The characters of a text in UTF-8. A byte that does not belong to one is the replacement character, U+FFFD.
std::vector<char32_t> characters_of(const char* text, std::size_t size);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/font.ipp>
#endif
