// Bodies of axes.hpp: axes in pictures: the directions of x, y and z in a corner, and numbers along the edges of a box.
#pragma once

#include <concino/render/axes.hpp>
#include <concino/render/detail/image/coverage.hpp>
#include <concino/render/detail/overlays/pixel_of.hpp>
#include <concino/render/detail/overlays/ticks.hpp>
#include <concino/render/text.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace concino {

namespace detail {

inline constexpr vec3 axis_directions[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// A line with a head.
inline void draw_arrow(image& picture, const pixel_position& from, const pixel_position& to, double size,
                       const rgb& color) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy),
               head = std::min(0.55 * size, length);
  if (!(length > 0)) return;
  const double x = dx / length, y = dy / length, half = 0.36 * head;
  const pixel_position base{to.x - x * head, to.y - y * head};
  draw_line(picture, from, base, std::max(1.0, size / 10), color);
  fill_polygon(picture,
               std::array<pixel_position, 3>{
                   {to, {base.x - y * half, base.y + x * half}, {base.x + y * half, base.y - x * half}}},
               color);
}

/// The distance of the origin of the arrows from the left and the lower edge, so that they and their names are inside.
inline double directions_room(double size) { return 4 * size; }

inline void draw_directions(image& picture, const camera& from, const axes_options& o, double size) {
  const double length = 2.4 * size, room = directions_room(size);
  const pixel_position origin{room, static_cast<double>(picture.height()) - room};
  const std::array<rgb, 3> colors = {srgb(0.75f, 0.10f, 0.10f), srgb(0.10f, 0.52f, 0.12f), srgb(0.12f, 0.25f, 0.80f)};
  std::array<std::size_t, 3> order = {0, 1, 2};  // the farthest first
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return dot(axis_directions[a], from.back) < dot(axis_directions[b], from.back);
  });
  for (const std::size_t a : order) {
    const double x = dot(axis_directions[a], from.right), y = -dot(axis_directions[a], from.up),
                 seen = std::hypot(x, y);
    draw_arrow(picture, origin, {origin.x + x * length, origin.y + y * length}, size, colors[a]);
    if (!(seen > 0.1)) continue;
    const double away = seen * length + 0.7 * size;
    draw_text(picture, o.names[a], {origin.x + x / seen * away, origin.y + y / seen * away},
              {.size = size, .color = colors[a], .align = text_align::middle, .level = text_level::middle});
  }
}

/// The box in the picture.
class seen_box {
  const box& box_;
  const camera& from_;
  std::size_t width_, height_;

 public:
  pixel_position middle;
  bool visible = true;

  seen_box(const image& picture, const camera& from, const box& b)
      : box_(b), from_(from), width_(picture.width()), height_(picture.height()) {
    for (std::size_t k = 0; k < 3; ++k)
      visible &= std::isfinite(b.min[k]) && std::isfinite(b.max[k]) && b.min[k] <= b.max[k];
    for (int corner = 0; corner < 8 && visible; ++corner) {
      const auto p =
          pixel_of(from_, width_, height_,
                   {corner & 1 ? b.max.x : b.min.x, corner & 2 ? b.max.y : b.min.y, corner & 4 ? b.max.z : b.min.z});
      visible = p.has_value();
      if (p) middle = {middle.x + p->x / 8, middle.y + p->y / 8};
    }
  }

  /// The point with this coordinate on the edge of an axis that is at the given sides of the next axis and the one
  /// after it.
  pixel_position at(std::size_t axis, double value, int edge) const {
    vec3 p;
    p[axis] = value;
    p[(axis + 1) % 3] = edge & 1 ? box_.max[(axis + 1) % 3] : box_.min[(axis + 1) % 3];
    p[(axis + 2) % 3] = edge & 2 ? box_.max[(axis + 2) % 3] : box_.min[(axis + 2) % 3];
    return pixel_of(from_, width_, height_, p).value_or(middle);
  }

  bool faces_viewer(std::size_t axis, bool high) const {
    const double side = high ? 1 : -1, place = high ? box_.max[axis] : box_.min[axis];
    return side * (from_.parallel ? from_.back[axis] : from_.eye[axis] - place) >
           1e-9 * (box_.max[axis] - box_.min[axis]);
  }

  /// The edge of an axis at the outline that is lowest in the picture, or most to the left if it is steep.
  std::optional<int> outline_edge(std::size_t axis) const {
    std::optional<int> best;
    double best_place = 0;
    for (int edge = 0; edge < 4; ++edge) {
      if (faces_viewer((axis + 1) % 3, edge & 1) == faces_viewer((axis + 2) % 3, edge & 2)) continue;
      const pixel_position a = at(axis, box_.min[axis], edge), b = at(axis, box_.max[axis], edge);
      const double place = std::abs(b.y - a.y) > 1.2 * std::abs(b.x - a.x) ? -(a.x + b.x) : a.y + b.y;
      if (best && !(place > best_place + 1e-6)) continue;
      best = edge;
      best_place = place;
    }
    return best;
  }
};

/// Writes numbers beside edges.
class number_writer {
  image& picture_;
  const axes_options& options_;
  double size_;
  std::vector<pixel_box> written_;

  bool is_inside(const pixel_position& p) const {
    return p.x >= 0 && p.y >= 0 && p.x <= static_cast<double>(picture_.width()) &&
           p.y <= static_cast<double>(picture_.height());
  }

  /// Writes a text beside p, in direction (x, y) of length 1, unless p is outside the picture or there is no room.
  /// Returns how far it extends in this direction, 0 if it is left out.
  double write(const std::string& text, const pixel_position& p, double x, double y, double away) {
    if (!is_inside(p)) return 0;
    const pixel_box b = text_box(text, {0, 0}, {.size = size_, .level = text_level::middle});
    const double half = std::abs(x) * b.width() / 2 + std::abs(y) * 0.37 * size_;
    pixel_position at{p.x + x * (away + half), p.y + y * (away + half)};
    const double w = static_cast<double>(picture_.width()), h = static_cast<double>(picture_.height());
    at.x = std::max(std::min(at.x, w - b.width() / 2), b.width() / 2);
    at.y = std::max(std::min(at.y, h + b.top), b.bottom);
    const double gap = 0.25 * size_;
    const pixel_box room{at.x - b.width() / 2 - gap, at.y + b.top, at.x + b.width() / 2 + gap, at.y + b.bottom};
    const auto meets = [&](const pixel_box& o) {
      return o.left < room.right && room.left < o.right && o.top < room.bottom && room.top < o.bottom;
    };
    if (std::any_of(written_.begin(), written_.end(), meets)) return 0;
    written_.push_back(room);
    draw_text(picture_, text, at,
              {.size = size_, .color = options_.color, .align = text_align::middle, .level = text_level::middle});
    return 2 * half;
  }

 public:
  number_writer(image& picture, const axes_options& options, double size)
      : picture_(picture), options_(options), size_(size) {
    const double height = static_cast<double>(picture.height()), room = 2 * directions_room(size);
    if (options.directions) written_.push_back({0, height - room, room, height});
  }

  void write_axis(const seen_box& b, std::size_t axis, double low, double high, int edge) {
    const pixel_position first = b.at(axis, low, edge), last = b.at(axis, high, edge);
    const double dx = last.x - first.x, dy = last.y - first.y, length = std::hypot(dx, dy);
    if (!(length > 1.5 * size_)) return;
    double x = -dy / length, y = dx / length;  // across the edge, away from the box
    if (x * ((first.x + last.x) / 2 - b.middle.x) + y * ((first.y + last.y) / 2 - b.middle.y) < 0) x = -x, y = -y;
    const double line = std::max(1.0, size_ / 16);
    draw_line(picture_, first, last, line, options_.color);
    const int count = std::max(1, std::min(options_.ticks, static_cast<int>(length / (3 * size_))));
    double extent = 0;
    for (const tick& t : round_ticks(low, high, count)) {
      const pixel_position p = b.at(axis, t.value, edge);
      draw_line(picture_, p, {p.x + x * 0.4 * size_, p.y + y * 0.4 * size_}, line, options_.color);
      extent = std::max(extent, write(t.text, p, x, y, 0.6 * size_));
    }
    for (const double part : {0.5, 0.7, 0.3, 0.85, 0.15})
      if (write(options_.names[axis], {first.x + part * dx, first.y + part * dy}, x, y, extent + 1.1 * size_) > 0)
        break;
  }
};

}  // namespace detail

CONCINO_INLINE void draw_axes(image& picture, const camera& from, const box& around, const axes_options& options) {
  if (!(options.size >= 0 && options.size <= 65535)) throw invalid_argument("draw_axes: size must be 0 to 65535");
  if (options.ticks < 1 || options.ticks > 100) throw invalid_argument("draw_axes: ticks must be 1 to 100");
  if (picture.width() == 0) return;
  const double least = static_cast<double>(std::min(picture.width(), picture.height()));
  const double size = std::min(
      options.size > 0 ? options.size : std::max(10.0, static_cast<double>(picture.height()) / 45), least / 8.5);
  if (options.numbers)
    if (const detail::seen_box seen(picture, from, around); seen.visible) {
      detail::number_writer writer(picture, options, size);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (const auto edge = seen.outline_edge(axis))
          writer.write_axis(seen, axis, around.min[axis], around.max[axis], *edge);
    }
  if (options.directions) detail::draw_directions(picture, from, options, size);
}

}  // namespace concino
