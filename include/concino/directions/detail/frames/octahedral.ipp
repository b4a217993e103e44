// Bodies of octahedral.hpp: frames up to the 24 rotations of a cube.
#pragma once

#include <concino/directions/detail/frames/octahedral.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace concino::detail {

CONCINO_INLINE quartic harmonics_at(const vec3& v) {
  const double x = v.x, y = v.y, z = v.z, xx = x * x, yy = y * y, zz = z * z;
  const double s35 = std::sqrt(35.0) / 8, s70 = std::sqrt(70.0) / 4, s5 = std::sqrt(5.0) / 4, s10 = std::sqrt(10.0) / 4;
  return {4 * s35 * x * y * (xx - yy),
          s70 * y * z * (3 * xx - yy),
          2 * s5 * x * y * (7 * zz - 1),
          s10 * y * z * (7 * zz - 3),
          (35 * zz * zz - 30 * zz + 3) / 8,
          s10 * x * z * (7 * zz - 3),
          s5 * (xx - yy) * (7 * zz - 1),
          s70 * x * z * (xx - 3 * yy),
          s35 * (xx * xx - 6 * xx * yy + yy * yy)};
}

CONCINO_INLINE quartic harmonics_of(const orthonormal_frame& f) {
  quartic sum{};
  for (const vec3& e : f) add(sum, harmonics_at(e));
  for (double& c : sum) c /= std::sqrt(21.0) / 2;  // P4(1) = 1 and P4(0) = 3/8: the squared length is 3 + 6 * 3/8
  return sum;
}

CONCINO_INLINE quartic harmonics_around(const vec3& n) {
  quartic h = harmonics_at(n);
  for (double& c : h) c *= std::sqrt(7.0 / 12);
  return h;
}

CONCINO_INLINE orthonormal_frame some_frame(const vec3& n) {
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  const vec3 other = x <= y && x <= z ? vec3{1, 0, 0} : y <= z ? vec3{0, 1, 0} : vec3{0, 0, 1};
  vec3 u = cross(n, other);
  u /= norm(u);
  return {n, u, cross(n, u)};
}

/// The angle by which two perpendicular vectors are turned in their plane so that the sum of q at both is largest. As a
/// function of the angle this sum has a mean and a wave of period 90 degrees, and nothing else.
CONCINO_INLINE double best_turn(const quartic& q, const vec3& a, const vec3& b) {
  const auto sum_at = [&](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return dot(q, harmonics_at(c * a + s * b)) + dot(q, harmonics_at(c * b - s * a));
  };
  constexpr double eighth = std::numbers::pi / 8;
  return std::atan2(sum_at(eighth) - sum_at(-eighth), sum_at(0) - sum_at(2 * eighth)) / 4;
}

CONCINO_INLINE void turn(vec3& a, vec3& b, double angle) {
  const vec3 x = std::cos(angle) * a + std::sin(angle) * b;
  b = std::cos(angle) * b - std::sin(angle) * a;
  a = x;
}

CONCINO_INLINE orthonormal_frame closest_aligned_frame(const quartic& q, const vec3& n) {
  orthonormal_frame f = some_frame(n);
  turn(f[1], f[2], best_turn(q, f[1], f[2]));
  return f;
}

/// A rotation of the frame of the coordinates.
CONCINO_INLINE orthonormal_frame rotated_axes(vec3 axis, double angle) {
  axis /= norm(axis);
  orthonormal_frame f;
  for (std::size_t k = 0; k < 3; ++k) {
    vec3 e;
    e[k] = 1;
    f[k] = std::cos(angle) * e + std::sin(angle) * cross(axis, e) + ((1 - std::cos(angle)) * dot(axis, e)) * axis;
  }
  return f;
}

CONCINO_INLINE closest_frame::closest_frame() {
  constexpr double pi = std::numbers::pi;
  std::vector<orthonormal_frame> all{rotated_axes({1, 0, 0}, 0)};
  for (const vec3& axis : {vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}}) all.push_back(rotated_axes(axis, pi / 4));
  for (const vec3& axis : {vec3{1, 1, 1}, vec3{-1, 1, 1}, vec3{1, -1, 1}, vec3{1, 1, -1}})
    all.push_back(rotated_axes(axis, pi / 3));
  for (const orthonormal_frame& f : all) candidates_.push_back({f, harmonics_of(f)});
}

CONCINO_INLINE orthonormal_frame closest_frame::operator()(const quartic& q, const orthonormal_frame& near) const {
  orthonormal_frame f = near;
  double best = dot(q, harmonics_of(near));
  for (const candidate& c : candidates_)
    if (const double value = dot(q, c.function); value > best) best = value, f = c.frame;
  for (int sweep = 0; sweep < 100; ++sweep) {
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      vec3 &a = f[(k + 1) % 3], &b = f[(k + 2) % 3];
      const double angle = best_turn(q, a, b);
      turn(a, b, angle);
      largest = std::max(largest, std::abs(angle));
    }
    if (!(largest > 1e-10)) break;
  }
  f[0] /= norm(f[0]);
  f[1] -= dot(f[0], f[1]) * f[0];
  f[1] /= norm(f[1]);
  f[2] = cross(f[0], f[1]);
  return f;
}

CONCINO_INLINE orthonormal_frame closest_frame::to_mean(std::span<const orthonormal_frame> frames) const {
  quartic sum{};
  for (const orthonormal_frame& f : frames) add(sum, harmonics_of(f));
  return (*this)(sum, frames.front());
}

CONCINO_INLINE orthonormal_frame turned_to(const orthonormal_frame& f, const orthonormal_frame& to) {
  double best = -4;
  orthonormal_frame nearest = f;
  for (std::size_t i = 0; i < 3; ++i)
    for (const std::size_t j : {(i + 1) % 3, (i + 2) % 3})
      for (const double si : {1.0, -1.0})
        for (const double sj : {1.0, -1.0}) {
          const vec3 a = si * f[i], b = sj * f[j], c = cross(a, b);
          const double value = concino::dot(a, to[0]) + concino::dot(b, to[1]) + concino::dot(c, to[2]);
          if (value > best) best = value, nearest = {a, b, c};
        }
  return nearest;
}

}  // namespace concino::detail
