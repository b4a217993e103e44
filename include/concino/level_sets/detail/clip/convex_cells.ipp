// Whether cells are convex; see convex_cells.hpp.
#pragma once

#include <concino/level_sets/detail/clip/convex_cells.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

CONCINO_INLINE bool is_vert_outside(std::span<const vec3> verts, std::span<const std::uint32_t> corners, bool outward) {
  vec3 mean, normal, previous;
  const vec3 origin = verts[corners[0]];
  const double n = static_cast<double>(corners.size());
  for (const std::uint32_t k : corners) {
    const vec3 step = verts[k] - origin;
    normal += outward ? cross(previous, step) : cross(step, previous);
    mean += step / n;
    previous = step;
  }
  double tolerance = -1;
  for (std::uint32_t i = 0; i < verts.size(); ++i) {
    const double height = dot(verts[i] - origin - mean, normal);
    if (!(height > 0) || std::find(corners.begin(), corners.end(), i) != corners.end()) continue;
    if (tolerance < 0) {
      double size = 0;
      for (const vec3& x : verts) size = std::max(size, norm(x - origin));
      tolerance = 1e-12 * norm(normal) * size;
    }
    if (height > tolerance) return true;
  }
  return false;
}

CONCINO_INLINE bool is_convex_cell(const crossed_volume& v, std::uint32_t cell) {
  std::vector<std::uint32_t> verts, corners;
  for (std::uint32_t k = v.first_corner[v.first_facet[cell]]; k < v.first_corner[v.first_facet[cell + 1]]; ++k)
    if (v.vert_indices[v.verts[k]] != v.none) verts.push_back(v.verts[k]);
  std::sort(verts.begin(), verts.end());
  verts.erase(std::unique(verts.begin(), verts.end()), verts.end());
  std::vector<vec3> points;
  for (const std::uint32_t x : verts) points.push_back(v.points[x]);
  const auto is_outside = [&](const std::uint32_t* first, const std::uint32_t* last, bool outward) {
    corners.clear();
    for (; first != last; ++first)
      corners.push_back(
          static_cast<std::uint32_t>(std::lower_bound(verts.begin(), verts.end(), *first) - verts.begin()));
    return is_vert_outside(points, corners, outward);
  };
  for (std::uint32_t s = v.first_facet[cell]; s < v.first_facet[cell + 1]; ++s) {
    const std::uint32_t fan = v.fan_of[s];
    if (fan == v.none) {
      if (is_outside(v.verts.data() + v.first_corner[s], v.verts.data() + v.first_corner[s + 1], v.outward[s] != 0))
        return false;
    } else if (s == v.fans[fan].first_facet) {
      if (is_outside(v.whole_verts.data() + v.fans[fan].first_corner, v.whole_verts.data() + v.fans[fan].last_corner,
                     v.outward[s] != 0))
        return false;
    }
  }
  return true;
}

}  // namespace concino::detail
