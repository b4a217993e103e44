// Defines support_finder.hpp.
#pragma once

#include <concino/print/detail/supports/support_finder.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace concino::detail {

CONCINO_INLINE support_finder::support_finder(std::vector<height_triangle> floors, double plate, double tolerance)
    : floors_(std::move(floors)), plate_(plate), tolerance_(tolerance) {
  if (floors_.empty()) return;
  turn_axes();
  build_grid();
}

/// To the main direction of the edges, if there is one.
CONCINO_INLINE void support_finder::turn_axes() {
  double cosines = 0, sines = 0, squares = 0;  // of twice the angles of edges, times their squared lengths
  for (const height_triangle& t : floors_)
    for (std::size_t k = 0; k < 3; ++k) {
      const vec3 &a = t.corners[k], &b = t.corners[k < 2 ? k + 1 : 0];
      const double x = (b.x - a.x) * (b.x - a.x), y = (b.y - a.y) * (b.y - a.y);
      cosines += x - y;
      sines += 2 * (b.x - a.x) * (b.y - a.y);
      squares += x + y;
    }
  if (!(std::hypot(cosines, sines) > 0.5 * squares)) return;
  const double angle = std::atan2(sines, cosines) / 2;
  cosine_ = std::cos(angle);
  sine_ = std::sin(angle);
}

CONCINO_INLINE support_finder::extents support_finder::extents_of(const height_triangle& t) const {
  double x[3], y[3];
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = cosine_ * t.corners[k].x + sine_ * t.corners[k].y;
    y[k] = cosine_ * t.corners[k].y - sine_ * t.corners[k].x;
  }
  const auto [x0, x1] = std::minmax({x[0], x[1], x[2]});
  const auto [y0, y1] = std::minmax({y[0], y[1], y[2]});
  return {x0, x1, y0, y1};
}

CONCINO_INLINE support_finder::cell_range support_finder::cells_of(const height_triangle& t) const {
  const extents e = extents_of(t);
  const auto cell = [](double at, std::size_t count) {
    return !(at > 0) ? 0 : at >= static_cast<double>(count) ? count - 1 : static_cast<std::size_t>(at);
  };
  return {cell((e.x0 - left_) / cell_width_, columns_), cell((e.x1 - left_) / cell_width_, columns_),
          cell((e.y0 - bottom_) / cell_height_, lines_), cell((e.y1 - bottom_) / cell_height_, lines_)};
}

/// Cells are so large that the triangles have at most some eight entries on average.
CONCINO_INLINE void support_finder::build_grid() {
  double right = -std::numeric_limits<double>::infinity(), top = right, widths = 0, heights = 0, boxes = 0;
  left_ = bottom_ = -right;
  for (const height_triangle& t : floors_) {
    const extents e = extents_of(t);
    left_ = std::min(left_, e.x0), right = std::max(right, e.x1);
    bottom_ = std::min(bottom_, e.y0), top = std::max(top, e.y1);
    widths += e.x1 - e.x0;
    heights += e.y1 - e.y0;
    boxes += (e.x1 - e.x0) * (e.y1 - e.y0);
  }
  const double n = static_cast<double>(floors_.size()), width = right - left_, height = top - bottom_;
  const double area = width * height / n, shape = widths / heights;
  cell_width_ = std::min(width, std::sqrt(area * shape));
  cell_height_ = std::min(height, area / cell_width_);
  cell_width_ = std::min(width, area / cell_height_);
  while (widths / cell_width_ + heights / cell_height_ + boxes / (cell_width_ * cell_height_) > 7 * n) {
    cell_width_ *= 1.5;
    cell_height_ *= 1.5;
  }
  columns_ = static_cast<std::size_t>(width / cell_width_) + 1;
  lines_ = static_cast<std::size_t>(height / cell_height_) + 1;
  cell_offsets_.assign(columns_ * lines_ + 1, 0);
  const auto for_each_cell = [&](const auto& visit) {
    for (std::uint32_t t = 0; t < floors_.size(); ++t) {
      const cell_range r = cells_of(floors_[t]);
      for (std::size_t j = r.j0; j <= r.j1; ++j)
        for (std::size_t i = r.i0; i <= r.i1; ++i) visit(j * columns_ + i, t);
    }
  };
  for_each_cell([&](std::size_t c, std::uint32_t) { ++cell_offsets_[c + 1]; });
  for (std::size_t c = 0; c + 1 < cell_offsets_.size(); ++c) cell_offsets_[c + 1] += cell_offsets_[c];
  cells_.resize(cell_offsets_.back());
  std::vector<std::uint32_t> next(cell_offsets_.begin(), cell_offsets_.end() - 1);
  for_each_cell([&](std::size_t c, std::uint32_t t) { cells_[next[c]++] = t; });
}

CONCINO_INLINE supports_size support_finder::below(const height_triangle& ceiling) const {
  std::vector<std::uint32_t> near;
  if (!floors_.empty()) {
    const cell_range r = cells_of(ceiling);
    for (std::size_t j = r.j0; j <= r.j1; ++j)
      for (std::size_t i = r.i0; i <= r.i1; ++i)
        for (std::uint32_t k = cell_offsets_[j * columns_ + i]; k < cell_offsets_[j * columns_ + i + 1]; ++k)
          if (floors_[cells_[k]].low <= ceiling.high + tolerance_) near.push_back(cells_[k]);
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
  }
  std::vector<const height_triangle*> candidates;
  candidates.reserve(near.size());
  for (const std::uint32_t t : near) candidates.push_back(&floors_[t]);
  return measure_supports(ceiling, std::move(candidates), plate_, tolerance_);
}

}  // namespace concino::detail
