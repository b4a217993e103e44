// Axes in pictures: the directions of x, y and z in a corner, and numbers along the edges of a box.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/render/camera.hpp>
#include <concino/render/image.hpp>

#include <array>
#include <string>

namespace concino {

struct axes_options {
  bool directions = true;                              // three arrows in the lower left corner
  bool numbers = true;                                 // along one edge of the box for each axis
  std::array<std::string, 3> names = {"x", "y", "z"};  // in UTF-8
  int ticks = 5;                        // about how many numbers for each axis, 1 to 100; fewer where the edge is short
                                        // in the picture
  double size = 0;                      // of letters in pixels, up to 65535; 0: 1/45 of the height of the picture, at
                                        // least 10
  rgb color = srgb(0.1f, 0.1f, 0.12f);  // of numbers and edges; arrows are red, green and blue
};

/// Draws axes into a picture.
/// Needs:  the camera with which the picture was made; a box around the scene, such as bounding_box(m). With
///         view_options::margin = 0.25 there is room for the numbers.
/// Result: for each axis the arrow, and an edge at the outline of the box, so that nothing is drawn over the scene,
///         with round numbers and a name. Those that would be cut off at the picture's edges are moved inside; those
///         that would lie on another one, or on the arrows, are left out. There are no numbers if the box is empty or
///         not wholly in front of the camera, and none along an axis that is seen from its end.
/// Cost:   as draw_text for all texts.
/// Errors: invalid_argument if an option is out of its range.
void draw_axes(image& picture, const camera& from, const box& around, const axes_options& options = {});

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/overlays/axes.ipp>
#endif
