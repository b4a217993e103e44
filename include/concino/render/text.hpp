// Text in pictures, in the font concino sans: Latin, Greek, superscripts and mathematical characters.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/image.hpp>

#include <string_view>

namespace concino {

/// What part of each line lies at the x of its position.
enum class text_align { left, middle, right };

/// What part of a text lies at the y of its position: the baseline of its first line, the top of its capital letters,
/// or the lower end of letters such as g in its last line. `middle` is midway between the top of capital letters and
/// the last baseline.
enum class text_level { baseline, middle, top, bottom };

struct text_options {
  double size = 20;       // of the em in pixels, above 0, up to 1e6: capital letters have 0.73 of it, lines are 1.2
                          // apart
  rgb color = {0, 0, 0};  // in linear light
  double opacity = 1;     // in [0, 1]
  concino::text_align align = concino::text_align::left;      // what lies at x
  concino::text_level level = concino::text_level::baseline;  // what lies at y
  bool keep_inside =
      true;  // a text that would be cut off at an edge of the picture is moved, and made smaller if it is larger than
             // the picture
};

/// Draws text, with edges smoothed by the area of each pixel that it covers.
/// Needs:  text in UTF-8; '\n' begins a new line. A character that the font does not have, and a byte that is not
///         UTF-8, is shown as an empty box.
/// Result: the box of what was drawn; without size, at the position, if nothing is visible.
/// Cost:   O(pixels of the box), and a triangulation of each character.
/// Errors: invalid_argument if an option is out of its range or the position is not finite.
pixel_box draw_text(image& picture, std::string_view text, const pixel_position& position,
                    const text_options& options = {});

/// The box of what draw_text would draw, in a picture without edges.
/// Needs:  as draw_text.
/// Result: as draw_text.      Cost: as draw_text without the pixels.
/// Errors: as draw_text.
pixel_box text_box(std::string_view text, const pixel_position& position, const text_options& options = {});

/// The width of the longest line of a text in pixels, spaces at its ends included.
/// Needs:  as draw_text; the size of the em in pixels, above 0, up to 1e6.
/// Result: proportional to the size.      Cost: O(length of the text).
/// Errors: invalid_argument if the size is out of its range.
double text_width(std::string_view text, double size);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/text/text.ipp>
#endif
