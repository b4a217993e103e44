// Bodies of overlays.hpp: what is drawn over a picture of a scene: its title, legend, axes and labels; and the camera
// that leaves room for them.
#pragma once

#include <concino/core/error.hpp>
#include <concino/render/detail/overlays/overlays.hpp>

#include <algorithm>

namespace concino::detail {

/// The appearance that the legend shows: that of the first thing with values or labels.
inline const appearance& look_of_legend(const scene& s) {
  for (const drawable& d : s.drawables())
    if (!d.values.empty() || !d.edge_values.empty()) return d.look;
  throw invalid_argument(
      "render: a legend is wanted, but nothing in the scene has values or labels; give a mesh a field");
}

CONCINO_INLINE camera camera_of(std::span<const drawable> framed, const scene& s, const render_options& o) {
  const double width = static_cast<double>(o.width), height = static_cast<double>(o.height);
  if (o.camera.has_camera()) return o.camera.of(framed, width / height, o.up);
  // The same room on both sides, so that the scene stays in the middle.
  double side = 0, above = 0;
  if (o.legend.wanted()) side = legend_box(o.width, o.height, look_of_legend(s), o.legend).width() + 0.03 * height;
  if (!o.title.empty()) above = height / 14;
  if (o.axes && o.axes->numbers) side = std::max(side, 0.07 * height), above = std::max(above, 0.06 * height);
  side = std::min(side, width / 4), above = std::min(above, height / 4);
  camera c = o.camera.of(framed, (width - 2 * side) / (height - 2 * above), o.up);
  c.half_height *= height / (height - 2 * above);
  return c;
}

CONCINO_INLINE void draw_overlays(image& picture, const camera& from, const scene& s,
                                  std::span<const point_label> visible_labels, const render_options& o) {
  if (o.axes) draw_axes(picture, from, s.bounds(), *o.axes);
  if (!visible_labels.empty()) draw_labels(picture, from, visible_labels, o.labels);
  if (o.legend.wanted()) draw_legend(picture, look_of_legend(s), o.legend);
  if (!o.title.empty()) draw_title(picture, o.title);
}

}  // namespace concino::detail
