// Bodies of turntable.hpp: turntables: pictures of a scene from all around, as the frames of a film.
#pragma once

#include <concino/render/turntable.hpp>

#include <algorithm>
#include <limits>

namespace concino::detail {

CONCINO_INLINE camera turned(camera c, const vec3& center, const vec3& axis, double angle) {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  // Rodrigues
  const auto turn = [&](const vec3& x) {
    return x * cosine + cross(axis, x) * sine + axis * (dot(axis, x) * (1 - cosine));
  };
  c.eye = center + turn(c.eye - center);
  c.right = turn(c.right), c.up = turn(c.up), c.back = turn(c.back);
  return c;
}

CONCINO_INLINE drawable turning_cylinder(std::span<const drawable> drawables, const vec3& center, const vec3& axis) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  double low = inf, high = -inf, radius = 0;
  for (const drawable& d : drawables)
    for (const vec3& p : d.points) {
      const vec3 x = p - center;
      const double height = dot(x, axis);
      low = std::min(low, height), high = std::max(high, height);
      radius = std::max(radius, norm(x - axis * height));
    }
  drawable circles;
  if (low > high) return circles;
  const frame around(axis);
  constexpr int num_points = 64;
  for (int i = 0; i < num_points; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / num_points;
    for (const double height : {low, high})
      circles.points.push_back(center + around.to_world(radius * std::cos(angle), radius * std::sin(angle), height));
  }
  return circles;
}

CONCINO_INLINE std::string frame_path(const std::string& path, int frame, int num_frames) {
  const std::size_t name = path.find_last_of('/') == std::string::npos ? 0 : path.find_last_of('/') + 1;
  const std::size_t dot = path.find_last_of('.');
  const std::size_t end = dot == std::string::npos || dot <= name ? path.size() : dot;
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(num_frames - 1).size());
  std::string number = std::to_string(frame);
  number.insert(0, digits - number.size(), '0');
  return core::joined({path.substr(0, end), "_", number, path.substr(end)});
}

}  // namespace concino::detail
