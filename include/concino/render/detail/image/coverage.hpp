// The fraction of each pixel that polygons cover, computed exactly.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/image.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace concino::detail {

/// Polygons over a part of a picture, of which they cover some pixels wholly and some in part. What lies outside is cut
/// off.
class coverage {
  std::size_t left_ = 0, top_ = 0, columns_ = 0, rows_ = 0;
  std::vector<double> changes_;  // of the coverage from each pixel to the one on its right

  void add_edge(const pixel_position& a, const pixel_position& b);

 public:
  /// The part of the picture in which the box lies.
  coverage(const image& picture, const pixel_box& box);

  /// Adds a polygon without self-intersections; corners are in either order.
  void add(std::span<const pixel_position> polygon);

  /// Paints the pixels in a colour, as far as they are covered. What several polygons cover is painted once.
  void paint(image& picture, const rgb& color, double opacity = 1) const;
};

/// Paints a polygon, a box, or a line with square ends.
void fill_polygon(image& picture, std::span<const pixel_position> polygon, const rgb& color, double opacity = 1);
void fill_box(image& picture, const pixel_box& box, const rgb& color, double opacity = 1);
void draw_line(image& picture, const pixel_position& a, const pixel_position& b, double width, const rgb& color,
               double opacity = 1);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/image/coverage.ipp>
#endif
