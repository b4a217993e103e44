// Bodies of labels.hpp: labels in pictures: texts beside points of the scene.
#pragma once

#include <concino/render/detail/image/coverage.hpp>
#include <concino/render/detail/overlays/pixel_of.hpp>
#include <concino/render/labels.hpp>
#include <concino/render/text.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace concino {

namespace detail {

struct pixel_segment {
  pixel_position a, b;
};

inline bool overlap(const pixel_box& a, const pixel_box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// Whether a part of the segment is inside the box. It is cut by the four edges in turn.
inline bool passes(const pixel_segment& s, const pixel_box& b) {
  double first = 0, last = 1;
  const auto cut = [&](double start, double change, double low, double high) {
    if (change == 0) return start > low && start < high;
    const double t = (low - start) / change, u = (high - start) / change;
    first = std::max(first, std::min(t, u));
    last = std::min(last, std::max(t, u));
    return first < last;
  };
  return cut(s.a.x, s.b.x - s.a.x, b.left, b.right) && cut(s.a.y, s.b.y - s.a.y, b.top, b.bottom);
}

/// Finds places for labels, one after another.
class label_places {
  double width_, height_, size_;
  std::vector<pixel_position> points_;
  std::vector<pixel_box> boxes_;
  std::vector<pixel_segment> lines_;

  bool is_free(const pixel_box& b, const pixel_segment& line, bool lines_too) const {
    if (!(b.left >= 0 && b.top >= 0 && b.right <= width_ && b.bottom <= height_)) return false;
    const double r = dot_radius();
    for (const pixel_position& p : points_)
      if (p.x > b.left - r && p.x < b.right + r && p.y > b.top - r && p.y < b.bottom + r) return false;
    for (const pixel_box& other : boxes_)
      if (overlap(b, other) || (lines_too && passes(line, other))) return false;
    return !lines_too ||
           std::none_of(lines_.begin(), lines_.end(), [&](const pixel_segment& s) { return passes(s, b); });
  }

 public:
  label_places(double width, double height, double size, std::vector<pixel_position> points)
      : width_(width), height_(height), size_(size), points_(std::move(points)) {}

  double dot_radius() const { return 0.17 * size_; }

  static pixel_position nearest(const pixel_box& b, const pixel_position& p) {
    return {std::min(std::max(p.x, b.left), b.right), std::min(std::max(p.y, b.top), b.bottom)};
  }

  /// A box of this width and height near p: to the right if it fits, else around it at growing distances. `lines_too`:
  /// lines to points and boxes must not meet either.
  std::optional<pixel_box> place(const pixel_position& p, double width, double height, bool lines_too) {
    constexpr double pi = 3.14159265358979323846;
    constexpr std::array<int, 16> turns = {0, 1,  -1, 8,  7, -7, 2, -2,
                                           6, -6, 3,  -3, 5, -5, 4, -4};  // eighths of half a turn; 8: to the left
    for (double away = 0.5 * size_; away < width_ + height_; away = 1.35 * away + 0.2 * size_)
      for (const int turn : turns) {
        // The corner or edge of the box that points back lies at the distance.
        const double x = std::cos(turn * pi / 8), y = -std::sin(turn * pi / 8);
        const auto offset = [](double direction, double length) {
          return std::abs(direction) < 0.3 ? -length / 2 : direction < 0 ? -length : 0;
        };
        const double left = p.x + away * x + offset(x, width),
                     top = p.y + away * y + (std::abs(x) > 0.8 ? -height / 2 : offset(y, height));
        const pixel_box b{left, top, left + width, top + height};
        const pixel_segment line{p, nearest(b, p)};
        if (!is_free(b, line, lines_too)) continue;
        boxes_.push_back(b);
        lines_.push_back(line);
        return b;
      }
    return {};
  }
};

inline void draw_dot(image& picture, const pixel_position& p, double radius, const rgb& color) {
  std::array<pixel_position, 20> circle;
  for (std::size_t k = 0; k < circle.size(); ++k) {
    const double angle = static_cast<double>(k) * 2 * 3.14159265358979323846 / static_cast<double>(circle.size());
    circle[k] = {p.x + radius * std::cos(angle), p.y + radius * std::sin(angle)};
  }
  fill_polygon(picture, circle, color);
}

}  // namespace detail

CONCINO_INLINE std::vector<pixel_box> draw_labels(image& picture, const camera& from,
                                                  std::span<const point_label> labels, const label_options& options) {
  if (!(options.size >= 0 && options.size <= 65535)) throw invalid_argument("draw_labels: size must be 0 to 65535");
  if (!(options.background_opacity >= 0 && options.background_opacity <= 1))
    throw invalid_argument("draw_labels: background_opacity must be in [0, 1]");
  const double width = static_cast<double>(picture.width()), height = static_cast<double>(picture.height());
  const double size = options.size > 0 ? options.size : std::max(10.0, height / 40);
  std::vector<std::optional<pixel_position>> at(labels.size());
  std::vector<pixel_position> points;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto p = detail::pixel_of(from, picture.width(), picture.height(), labels[i].point);
    if (!p || !(p->x >= 0 && p->x <= width && p->y >= 0 && p->y <= height)) continue;
    at[i] = p;
    points.push_back(*p);
  }
  std::vector<pixel_box> boxes(labels.size());
  detail::label_places places(width, height, size, points);
  const double border = 0.2 * size;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!at[i] || labels[i].text.empty()) continue;
    const pixel_box text = text_box(labels[i].text, {0, 0}, {.size = size});
    for (const bool lines_too : {true, false})
      if (!(boxes[i].width() > 0))
        if (const auto b = places.place(*at[i], text.width() + 2 * border, text.height() + 2 * border, lines_too))
          boxes[i] = *b;
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!at[i]) continue;
    if (options.dots) detail::draw_dot(picture, *at[i], places.dot_radius(), options.color);
    if (!(boxes[i].width() > 0)) continue;
    const pixel_position end = detail::label_places::nearest(boxes[i], *at[i]);
    if (std::hypot(end.x - at[i]->x, end.y - at[i]->y) > 0.7 * size)
      detail::draw_line(picture, *at[i], end, std::max(1.0, size / 16), options.color);
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const pixel_box& b = boxes[i];
    if (!(b.width() > 0)) continue;
    detail::fill_box(picture, b, options.background, options.background_opacity);
    const pixel_box text = text_box(labels[i].text, {0, 0}, {.size = size});
    draw_text(picture, labels[i].text, {b.left + border - text.left, b.top + border - text.top},
              {.size = size, .color = options.color});
  }
  return boxes;
}

}  // namespace concino
