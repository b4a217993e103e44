// Legends and titles of pictures: which colour means which value.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/appearance.hpp>
#include <concino/render/image.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace concino {

/// The edge of the picture at which a legend stands.
enum class legend_place { right, left };

struct legend_options {
  std::string title = {};                                      // above the legend, in UTF-8
  std::string unit = {};                                       // in brackets after the title
  bool show = false;                                           // where a legend is optional: whether it is drawn
                                                               // without title and unit
  concino::legend_place place = concino::legend_place::right;  // which edge
  double size = 0;                       // of letters in pixels, up to 65535; 0: 1/40 of the height of the picture, at
                                         // least 10
  int ticks = 6;                         // about how many numbers, 1 to 100
  std::vector<std::string> labels = {};  // for an appearance with labels: the name of each, from 0; empty: their
                                         // numbers
  std::string no_value = {};             // a name for the colour of points without a value; empty: not shown
  rgb color = srgb(0.1f, 0.1f, 0.12f);   // of letters and lines

  bool wanted() const { return show || !title.empty() || !unit.empty(); }
};

/// Draws the legend of an appearance: a bar of its colour map with round numbers, its bands and iso-lines; or the
/// colours of its labels.
/// Needs:  a picture of any size: in a small one the legend is smaller. Texts as draw_text.
/// Result: the box of the legend, which lies inside the picture. Numbers are where the scale has them, also if it is
///         not linear.
/// Cost:   as draw_text for all texts.
/// Errors: invalid_argument if an option is out of its range.
pixel_box draw_legend(image& picture, const appearance& look, const legend_options& options = {});

/// The box of what draw_legend would draw, so that the rest of the picture can be kept free of it.
/// Needs:  width and height of the picture in pixels.
/// Result: as draw_legend.      Cost: as draw_legend without the pixels.
/// Errors: as draw_legend.
pixel_box legend_box(std::size_t width, std::size_t height, const appearance& look, const legend_options& options = {});

/// Draws a title in the middle of the upper edge. Letters have 1/24 of the height of the picture, or less if the title
/// would be too long.
/// Needs:  text as draw_text.
/// Result: the box of the title, inside the picture.      Cost: as draw_text.
/// Errors: none.
pixel_box draw_title(image& picture, std::string_view title, const rgb& color = srgb(0.1f, 0.1f, 0.12f));

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/overlays/legend.ipp>
#endif
