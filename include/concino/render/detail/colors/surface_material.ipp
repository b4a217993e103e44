// Bodies of surface_material.hpp: materials: how the light that a surface sends to the viewer depends on its normal.
#pragma once

#include <concino/render/surface_material.hpp>

#include <algorithm>
#include <cmath>

namespace concino {

namespace detail {

/// From 0 below a to 1 above b, smoothly.
CONCINO_INLINE double smooth_step(double a, double b, double x) {
  const double t = std::min(1.0, std::max(0.0, (x - a) / (b - a)));
  return t * t * (3 - 2 * t);
}

CONCINO_INLINE rgb grey(double x) {
  const float light = static_cast<float>(x);
  return {light, light, light};
}

}  // namespace detail

CONCINO_INLINE rgb surface_material::operator()(const vec3& n) const {
  const vec3 toward_light{-0.45, 0.60, 0.66}, halfway{-0.247, 0.329, 0.911};  // halfway between light and viewer
  // light that reaches behind the horizon a little
  const double soft = std::max(0.0, (dot(n, toward_light) + 0.35) / 1.35);
  const double contour = std::pow(1 - std::min(1.0, std::max(0.0, n.z)), 3);
  const double glint = std::max(0.0, dot(n, halfway));
  switch (kind_) {
    case kind::matte: return detail::grey(0.22 + 0.88 * soft);
    case kind::clay:
      return mix(rgb{0.30f, 0.13f, 0.09f}, rgb{1.15f, 0.78f, 0.62f}, static_cast<float>(soft)) *
             static_cast<float>(1 - 0.5 * contour);
    case kind::porcelain: return detail::grey(0.42 + 0.60 * soft + 0.9 * std::pow(glint, 120) + 0.25 * contour);
    case kind::metal: {
      const double above = 2 * n.z * n.y;  // height of the reflected direction
      const double sky = detail::smooth_step(-0.06, 0.10, above),
                   ground = 0.10 + 0.35 * detail::smooth_step(-0.05, -1, above);
      return detail::grey(ground * (1 - sky) + sky * (0.55 + 0.55 * above) + 0.7 * std::pow(glint, 60));
    }
    case kind::picture: return ball_(0.5 + 0.5 * n.x, 0.5 + 0.5 * n.y).color;
    case kind::daylight: break;
  }
  return {1, 1, 1};
}

}  // namespace concino
