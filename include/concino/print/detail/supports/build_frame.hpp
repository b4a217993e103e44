// Coordinates along and across the direction in which a part is built.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>
#include <concino/print/detail/supports/part_surface.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace concino::detail {

/// Three unit vectors: x, y span the plate, up points away from it. For the direction of z they are the axes.
struct build_frame {
  vec3 x, y, up;

  explicit build_frame(const vec3& unit_direction) : up(unit_direction) {
    const double sizes[] = {std::abs(up.x), std::abs(up.y), std::abs(up.z)};
    vec3 axis;
    axis[static_cast<std::size_t>(std::min_element(sizes, sizes + 3) - sizes)] = 1;
    x = axis - dot(axis, up) * up;
    x /= norm(x);
    y = cross(up, x);
  }
  vec3 operator()(const vec3& p) const { return {dot(p, x), dot(p, y), dot(p, up)}; }
  vec3 to_world(const vec3& p) const { return p.x * x + p.y * y + p.z * up; }
};

/// The direction, scaled to length 1. `caller` is named in messages.
inline vec3 checked_direction(const vec3& direction, const char* caller) {
  const double size = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
  if (!is_finite(direction) || !(size > 0))
    core::throw_joined<invalid_argument>({caller, ": options.direction must be finite and not 0"});
  const vec3 d = direction / size;
  return d / norm(d);
}

/// The height of the plate, which is given in units of the mesh, in those of the part; without it, that of the lowest
/// point. It may be above that by `near`.
inline double plate_height(const part_surface& part, const std::optional<double>& plate, const vec3& up, double lowest,
                           double near, const char* caller) {
  if (!plate) return lowest;
  if (!std::isfinite(*plate)) core::throw_joined<invalid_argument>({caller, ": options.plate is not finite"});
  const double height = part.height_from_mesh(*plate, up);
  if (!part.points.empty() && height > lowest + near)
    core::throw_joined<invalid_argument>({caller, ": options.plate is above the lowest point of the part"});
  return height;
}

}  // namespace concino::detail
