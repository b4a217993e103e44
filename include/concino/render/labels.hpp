// Labels in pictures: texts beside points of the scene.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/render/camera.hpp>
#include <concino/render/image.hpp>

#include <span>
#include <string>
#include <vector>

namespace concino {

/// A text at a point in space.
struct point_label {
  vec3 point;
  std::string text;
};

struct label_options {
  double size = 0;                      // of letters in pixels, up to 65535; 0: 1/40 of the height of the picture, at
                                        // least 10
  rgb color = srgb(0.1f, 0.1f, 0.12f);  // of letters, and of the lines from points to texts
  rgb background = {1, 1, 1};           // behind the text
  double background_opacity = 0.8;      // in [0, 1]
  bool dots = true;                     // marks the points
};

/// Draws texts beside the points where a camera sees them. What hides the points is not regarded: leave out hidden
/// ones.
/// Needs:  the camera with which the picture was made. Texts as draw_text.
/// Result: the box of each label. Boxes lie inside the picture and do not overlap each other or cover the points. A
///         text that has to be farther from its point has a line to it. A box without width: the point is not in the
///         picture, or there is no room left. Earlier labels are placed first.
/// Cost:   O(n^2) for n labels, and the pixels of their boxes.
/// Errors: invalid_argument if an option is out of its range.
std::vector<pixel_box> draw_labels(image& picture, const camera& from, std::span<const point_label> labels,
                                   const label_options& options = {});

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/overlays/labels.ipp>
#endif
