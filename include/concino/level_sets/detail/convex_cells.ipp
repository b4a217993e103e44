// Whether cells are convex; see convex_cells.hpp.
#pragma once

#include <concino/level_sets/detail/convex_cells.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

CONCINO_INLINE bool is_convex_cell(const crossed_volume& v, std::uint32_t cell) {
  std::vector<std::uint32_t> verts;
  for (std::uint32_t k = v.first_corner[v.first_facet[cell]]; k < v.first_corner[v.first_facet[cell + 1]]; ++k)
    if (v.vert_indices[v.verts[k]] != v.none) verts.push_back(v.verts[k]);
  std::sort(verts.begin(), verts.end());
  verts.erase(std::unique(verts.begin(), verts.end()), verts.end());
  const auto is_outside = [&](const std::uint32_t* first, const std::uint32_t* last, bool outward) {
    vec3 mean, normal, previous;
    double size = 0;
    const vec3 origin = v.points[*first];
    for (const std::uint32_t* k = first; k != last; ++k) {
      const vec3 step = v.points[*k] - origin;
      normal += outward ? cross(previous, step) : cross(step, previous);
      mean += step / static_cast<double>(last - first);
      previous = step;
    }
    for (const std::uint32_t x : verts) size = std::max(size, norm(v.points[x] - origin));
    const double tolerance = 1e-12 * norm(normal) * size;
    return std::any_of(verts.begin(), verts.end(), [&](std::uint32_t x) {
      return std::find(first, last, x) == last && dot(v.points[x] - origin - mean, normal) > tolerance;
    });
  };
  for (std::uint32_t s = v.first_facet[cell]; s < v.first_facet[cell + 1]; ++s) {
    const std::uint32_t fan = v.fan_of[s];
    if (fan == v.none) {
      if (is_outside(v.verts.data() + v.first_corner[s], v.verts.data() + v.first_corner[s + 1], v.outward[s] != 0)) return false;
    } else if (s == v.fans[fan].first_facet) {
      if (is_outside(v.whole_verts.data() + v.fans[fan].first_corner, v.whole_verts.data() + v.fans[fan].last_corner, v.outward[s] != 0)) return false;
    }
  }
  return true;
}

}  // namespace concino::detail
