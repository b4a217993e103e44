// Bodies of coverage.hpp: the part of each pixel that polygons cover, exactly.
#pragma once

#include <concino/render/detail/image/coverage.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace concino::detail {

/// The pixel that a coordinate lies in, from 0 to `end`; 0 for one that is not a number.
inline std::size_t pixel_index(double x, std::size_t end) {
  const double limit = static_cast<double>(end);
  return !(x > 0) ? 0 : x < limit ? static_cast<std::size_t>(x) : end;
}

CONCINO_INLINE coverage::coverage(const image& picture, const pixel_box& box) {
  left_ = pixel_index(std::floor(box.left), picture.width());
  top_ = pixel_index(std::floor(box.top), picture.height());
  const std::size_t right = pixel_index(std::ceil(box.right), picture.width()),
                    bottom = pixel_index(std::ceil(box.bottom), picture.height());
  columns_ = right > left_ ? right - left_ : 0;
  rows_ = bottom > top_ ? bottom - top_ : 0;
  changes_.assign(rows_ * (columns_ + 1), 0.0);
}

/// Adds the area between an edge and the right end of the picture, with the sign of its direction. For all edges of a
/// polygon, the sum is its area.
CONCINO_INLINE void coverage::add_edge(const pixel_position& a, const pixel_position& b) {
  const double slope = (b.x - a.x) / (b.y - a.y), x0 = static_cast<double>(left_), y0 = static_cast<double>(top_);
  if (!std::isfinite(slope)) return;  // a level edge
  const double sign = b.y > a.y ? 1 : -1;
  const double first = std::max(std::min(a.y, b.y) - y0, 0.0),
               last = std::min(std::max(a.y, b.y) - y0, static_cast<double>(rows_));
  for (double y = first; y < last;) {
    const double next = std::min(std::floor(y) + 1, last);
    // In this row the edge runs from column `low` to `high`, evenly. The mean, over its points x, of the length of (x,
    // t) is known for each t.
    const double xa = a.x - x0 + slope * (y + y0 - a.y), xb = a.x - x0 + slope * (next + y0 - a.y),
                 low = std::min(xa, xb), high = std::max(xa, xb);
    if (!std::isfinite(low) || !std::isfinite(high)) return;
    const auto mean_length = [&](double t) {
      return t <= low ? 0 : t >= high ? t - (low + high) / 2 : (t - low) * (t - low) / (2 * (high - low));
    };
    double* const row = changes_.data() + static_cast<std::size_t>(y) * (columns_ + 1);
    const std::size_t start = pixel_index(low, columns_), stop = pixel_index(high + 1, columns_);
    double before = 0, length = mean_length(static_cast<double>(start));
    for (std::size_t c = start; c < stop; ++c) {
      const double to = mean_length(static_cast<double>(c + 1)), covered = to - length;
      row[c] += sign * (next - y) * (covered - before);
      before = covered;
      length = to;
    }
    row[stop] += sign * (next - y) * (1 - before);
    y = next;
  }
}

CONCINO_INLINE void coverage::add(std::span<const pixel_position> polygon) {
  double area = 0;
  for (std::size_t i = 0, before = polygon.size() - 1; i < polygon.size(); before = i++)
    area += (polygon[before].x - polygon[0].x) * (polygon[i].y - polygon[0].y) -
            (polygon[i].x - polygon[0].x) * (polygon[before].y - polygon[0].y);
  for (std::size_t i = 0, before = polygon.size() - 1; i < polygon.size(); before = i++)
    if (area < 0) add_edge(polygon[before], polygon[i]);
    else add_edge(polygon[i], polygon[before]);
}

/// Lays a colour over a pixel.
inline void blend(image& picture, std::size_t x, std::size_t y, const rgb& color, float part) {
  rgb& pixel = picture(x, y);
  if (!picture.has_opacity()) {
    pixel = mix(pixel, color, part);
    return;
  }
  float& opacity = picture.opacity(x, y);
  const float sum = part + opacity * (1 - part);
  if (sum > 0) pixel = mix(pixel, color, part / sum);
  opacity = sum;
}

CONCINO_INLINE void coverage::paint(image& picture, const rgb& color, double opacity) const {
  for (std::size_t r = 0; r < rows_; ++r) {
    double sum = 0;
    for (std::size_t c = 0; c < columns_; ++c) {
      sum += changes_[r * (columns_ + 1) + c];
      const double part = std::min(1.0, sum) * opacity;
      if (part > 1e-6) blend(picture, left_ + c, top_ + r, color, static_cast<float>(part));
    }
  }
}

CONCINO_INLINE void fill_polygon(image& picture, std::span<const pixel_position> polygon, const rgb& color,
                                 double opacity) {
  if (polygon.empty()) return;
  pixel_box box{polygon[0].x, polygon[0].y, polygon[0].x, polygon[0].y};
  for (const pixel_position& p : polygon)
    box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x), std::max(box.bottom, p.y)};
  coverage c(picture, box);
  c.add(polygon);
  c.paint(picture, color, opacity);
}

CONCINO_INLINE void fill_box(image& picture, const pixel_box& b, const rgb& color, double opacity) {
  fill_polygon(
      picture,
      std::array<pixel_position, 4>{{{b.left, b.top}, {b.right, b.top}, {b.right, b.bottom}, {b.left, b.bottom}}},
      color, opacity);
}

CONCINO_INLINE void draw_line(image& picture, const pixel_position& a, const pixel_position& b, double width,
                              const rgb& color, double opacity) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
  if (!(length > 0)) return;
  const double x = -dy / length * width / 2, y = dx / length * width / 2;
  fill_polygon(
      picture,
      std::array<pixel_position, 4>{{{a.x + x, a.y + y}, {b.x + x, b.y + y}, {b.x - x, b.y - y}, {a.x - x, a.y - y}}},
      color, opacity);
}

}  // namespace concino::detail
