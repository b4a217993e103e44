// Bodies of affine_map.hpp: affine maps of space: rotations, translations and what is composed of them.
#pragma once

#include <concino/core/error.hpp>
#include <concino/deform/affine_map.hpp>
#include <concino/deform/detail/skin/best_rotation.hpp>

#include <algorithm>
#include <cmath>

namespace concino {

CONCINO_INLINE affine_map translation(const vec3& v) {
  if (!is_finite(v)) core::throw_joined<invalid_argument>({"translation: the vector is not finite"});
  affine_map f;
  f.origin = v;
  return f;
}

CONCINO_INLINE affine_map rotation(const vec3& on_axis, const vec3& axis, double angle) {
  const double length = norm(axis);
  if (!is_finite(on_axis) || !std::isfinite(length) || !(length > 0) || !std::isfinite(angle))
    core::throw_joined<invalid_argument>(
        {"rotation: the point, the axis and the angle must be finite, and the axis must have a length"});
  const vec3 a = axis / length;
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turned = [&](const vec3& v) { return c * v + s * cross(a, v) + (1 - c) * dot(a, v) * a; };
  affine_map f{turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}), {}};
  f.origin = on_axis - f.turn(on_axis);
  return f;
}

CONCINO_INLINE bool is_rigid(const affine_map& f, double tolerance) {
  const auto near = [&](double a, double b) { return std::abs(a - b) <= tolerance; };
  return is_finite(f.origin) && near(dot(f.x, f.x), 1) && near(dot(f.y, f.y), 1) && near(dot(f.z, f.z), 1) &&
         near(dot(f.x, f.y), 0) && near(dot(f.y, f.z), 0) && near(dot(f.z, f.x), 0) && dot(f.x, cross(f.y, f.z)) > 0;
}

CONCINO_INLINE affine_map best_rigid_motion(const std::vector<vec3>& from, const std::vector<vec3>& to) {
  if (from.size() != to.size())
    core::throw_joined<invalid_argument>(
        {"best_rigid_motion: there are ", from.size(), " points to move, and ", to.size(), " to move them to"});
  vec3 a, b;
  const auto n = static_cast<double>(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!is_finite(from[i]) || !is_finite(to[i]))
      core::throw_joined<invalid_argument>({"best_rigid_motion: point ", i, " has a coordinate that is not finite"});
    a += from[i] / n;
    b += to[i] / n;
  }
  double size = 0;
  for (std::size_t i = 0; i < from.size(); ++i) size = std::max({size, norm(from[i] - a), norm(to[i] - b)});
  detail::moment_matrix moments;
  if (size > 0)
    for (std::size_t i = 0; i < from.size(); ++i) moments.add(1, (from[i] - a) / size, (to[i] - b) / size);
  const auto r = detail::best_rotation(moments);
  affine_map f{r[0], r[1], r[2], {}};
  f.origin = b - f.turn(a);
  return f;
}

}  // namespace concino
