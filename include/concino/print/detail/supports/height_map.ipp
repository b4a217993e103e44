// Defines height_map.hpp.
#pragma once

#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/orientation.hpp>
#include <concino/print/detail/supports/build_frame.hpp>
#include <concino/print/detail/supports/supports.hpp>
#include <concino/print/height_map.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

/// Raises the heights of the cells below a triangle. The map's cells have the size `cell`, and begin at `low`.
inline void raise_heights(height_map_result& map, const height_triangle& t, const vec3& low, double cell) {
  box bounds;
  for (const vec3& c : t.corners) bounds.add(c);
  const auto first = [&](double x, double from) {
    return static_cast<std::size_t>(std::max(0.0, std::ceil((x - from) / cell - 0.5 - 1e-6)));
  };
  const auto last = [&](double x, double from, std::size_t count) {
    const double i = std::floor((x - from) / cell - 0.5 + 1e-6);
    return i < 0 ? 0 : std::min(count, static_cast<std::size_t>(i) + 1);
  };
  const auto& c = t.corners;
  for (std::size_t j = first(bounds.min.y, low.y); j < last(bounds.max.y, low.y, map.rows); ++j)
    for (std::size_t i = first(bounds.min.x, low.x); i < last(bounds.max.x, low.x, map.columns); ++i) {
      const vec3 x{low.x + (static_cast<double>(i) + 0.5) * cell, low.y + (static_cast<double>(j) + 0.5) * cell, 0};
      if (orient2d(c[0], c[1], x) < 0 || orient2d(c[1], c[2], x) < 0 || orient2d(c[2], c[0], x) < 0) continue;
      double& height = map.heights[j * map.columns + i];
      height = std::max(height, t.at(x.x, x.y) - low.z);
    }
}

CONCINO_INLINE height_map_result fill_height_map(const part_surface& part, const height_map_options& options) {
  const build_frame frame(checked_direction(options.direction, "height_map"));
  if (options.resolution < 1 || options.resolution > 16384)
    throw invalid_argument("height_map: options.resolution must be in [1, 16384]");
  height_map_result map;
  std::vector<vec3> points;
  box bounds;
  for (const vec3& x : part.points) {
    points.push_back(frame(x));
    bounds.add(points.back());
  }
  vec3 low = bounds.min;
  low.z = plate_height(part, options.plate, frame.up, low.z, part.tolerance, "height_map");
  if (part.points.empty()) return map;
  const vec3 extent = bounds.max - bounds.min;
  const double longer = std::max(extent.x, extent.y), cell = longer / static_cast<double>(options.resolution);
  const auto count = [&](double length) {
    return std::clamp(static_cast<std::size_t>(std::ceil(length / cell - 1e-9)), std::size_t{1}, options.resolution);
  };
  map.columns = count(extent.x);
  map.rows = count(extent.y);
  map.heights.assign(map.columns * map.rows, 0.0);
  for (const auto& v : part.triangles) {
    height_triangle t;
    const int facing = make_height_triangle({points[v[0]], points[v[1]], points[v[2]]}, part.tolerance, t);
    if (facing != 0) raise_heights(map, t, low, cell);
  }
  for (double& h : map.heights) h = part.to_mesh(h, 1);
  map.origin = part.to_mesh(frame.to_world({low.x + 0.5 * cell, low.y + 0.5 * cell, low.z}));
  map.step_x = part.to_mesh(cell, 1) * frame.x;
  map.step_y = part.to_mesh(cell, 1) * frame.y;
  return map;
}

}  // namespace concino::detail
