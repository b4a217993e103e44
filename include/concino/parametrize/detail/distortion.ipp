// Bodies of distortion.hpp: the distortion of a map to the plane, from flat arrays.
#pragma once

#include <concino/core/error.hpp>
#include <concino/parametrize/detail/distortion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace concino::detail {

/// Scales points of the plane to a size near 1, and returns the power of 2 they are in units of.
inline int scale_points(std::vector<uv_point>& uv) {
  double largest = 0;
  for (const uv_point& x : uv) largest = std::max({largest, std::abs(x[0]), std::abs(x[1])});
  if (!(largest > 0)) return 0;
  const int e = std::ilogb(largest);
  for (uv_point& x : uv) x = {std::ldexp(x[0], -e), std::ldexp(x[1], -e)};
  return e;
}

CONCINO_INLINE flat_distortion distortion_of(const flat_polys& f, std::vector<uv_point> uv) {
  for (std::size_t c = 0; c < uv.size(); ++c)
    if (!std::isfinite(uv[c][0]) || !std::isfinite(uv[c][1]))
      core::throw_joined<invalid_argument>(
          {"map_distortion: the map has a point that is not finite at vert ", f.vert_index[f.corners[c]]});
  const int unit = scale_points(uv) - f.exponent;  // lengths change by 2^unit more than derivatives say
  const poly_triangles cut(f);
  const std::size_t n = f.num_polys();
  flat_distortion d{std::vector<double>(n, 0), std::vector<double>(n, 1), std::vector<double>(n, 1),
                    std::vector<unsigned char>(n, 0)};
  std::vector<double> ratio(n, -1);  // negative: the poly has no area on the surface
  double flat_area = 0, weighted = 0;
  for (std::size_t p = 0; p < n; ++p) {
    double here = 0, there = 0;
    for (std::uint32_t i = cut.first[p]; i < cut.first[p + 1]; ++i) {
      const plane_triangle& t = cut.triangles[i];
      const uv_point &a = uv[t.corner[0]], &b = uv[t.corner[1]], &c = uv[t.corner[2]];
      const double twice = twice_area(a, b, c);
      if (!(twice > 0)) d.is_flipped[p] = 1;
      if (!(t.area > 0)) continue;
      const auto [large, small] = singular_values(t.derivative(a, b, c));
      const double angle =
          twice > 0 && small > 0 ? 2 * std::asin(std::min(1.0, (large - small) / (large + small))) : std::numbers::pi;
      d.angle[p] = std::max(d.angle[p], angle);
      const double shortest = std::abs(small);
      d.stretch[p] = std::max({d.stretch[p], std::ldexp(large, unit),
                               shortest > 0 ? std::ldexp(1 / shortest, -unit)
                                            : std::numeric_limits<double>::infinity()});
      here += t.area;
      there += std::abs(twice) / 2;
    }
    if (!(here > 0)) continue;
    ratio[p] = there / here;
    flat_area += there;
    weighted += here * d.angle[p];
    d.max_angle = std::max(d.max_angle, d.angle[p]);
    d.max_stretch = std::max(d.max_stretch, d.stretch[p]);
  }
  if (!(cut.area > 0)) return d;
  d.mean_angle = weighted / cut.area;
  d.scale = std::ldexp(flat_area / cut.area, 2 * unit);
  if (!(flat_area > 0)) return d;
  for (std::size_t p = 0; p < n; ++p) {
    if (ratio[p] < 0) continue;
    d.area[p] = ratio[p] / (flat_area / cut.area);
    d.min_area = std::min(d.min_area, d.area[p]);
    d.max_area = std::max(d.max_area, d.area[p]);
  }
  return d;
}

}  // namespace concino::detail
