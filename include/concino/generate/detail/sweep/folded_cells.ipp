// Bodies of folded_cells.hpp: finds the cells between a surface and its offset that are inverted at a corner.
#pragma once

#include <concino/generate/detail/sweep/folded_cells.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

/// The verts of a corner of a polygon, as points of a level.
struct corner_of_level {
  const swept_surface& s;
  const std::vector<vec3>& normals;
  std::uint32_t before, at, after;

  vec3 in_level(std::uint32_t v, double height) const { return s.points[v] + height * normals[v]; }
  /// The cross product of the edges from the corner to the next vert and to the one before, scaled to a length of about
  /// 1.
  vec3 area(double height) const {
    const vec3 x = in_level(at, height), a = about_unit(in_level(after, height) - x),
               b = about_unit(in_level(before, height) - x);
    return cross(a, b);
  }
  /// Whether the edge to the next vert has turned by 90 degrees or more, as beyond a centre of curvature.
  bool is_reversed(double height) const {
    return !(dot(about_unit(in_level(after, height) - in_level(at, height)),
                 about_unit(s.points[after] - s.points[at])) > 0);
  }
  static vec3 about_unit(const vec3& a) {
    const double size = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
    return size > 0 ? a / size : a;
  }
};

CONCINO_INLINE std::vector<poly_id> folded_cells(const swept_surface& s, const std::vector<vec3>& normals,
                                                 double thickness, std::size_t num_layers) {
  const std::size_t n = s.num_polys();
  std::vector<std::uint8_t> is_folded(n * (num_layers + 1), 0);  // whether the polygon in a level has a corner that is
                                                                 // inverted
  parallel_for(n, [&](std::size_t p) {
    const std::uint32_t first = s.offsets[p], size = s.offsets[p + 1] - first;
    vec3 whole;  // the direction of the polygon, to know its corners with angles above 180 degrees
    for (std::uint32_t k = 1; k + 1 < size; ++k)
      whole += cross(corner_of_level::about_unit(s.points[s.verts[first + k]] - s.points[s.verts[first]]),
                     corner_of_level::about_unit(s.points[s.verts[first + k + 1]] - s.points[s.verts[first]]));
    for (std::uint32_t k = 0; k < size; ++k) {
      const corner_of_level c{s, normals, s.verts[first + (k == 0 ? size - 1 : k - 1)], s.verts[first + k],
                              s.verts[first + (k + 1 == size ? 0 : k + 1)]};
      const double turn = dot(c.area(0), whole);
      if (!(std::abs(turn) > 1e-12)) continue;
      const vec3 up = (thickness < 0) == (turn < 0) ? normals[c.at] : -normals[c.at];
      for (std::size_t level = 0; level <= num_layers; ++level) {
        const double height = thickness * (static_cast<double>(level) / static_cast<double>(num_layers));
        if (!(dot(c.area(height), up) > 0) || c.is_reversed(height)) is_folded[level * n + p] = 1;
      }
    }
  });
  std::vector<poly_id> found;
  for (std::size_t i = 0; i < n * num_layers; ++i)
    if (is_folded[i] || is_folded[i + n]) found.push_back(poly_id{i});
  return found;
}

}  // namespace concino::detail
