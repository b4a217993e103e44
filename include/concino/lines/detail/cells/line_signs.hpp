// On which side of a line along a field points lie, by exact signs.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace concino::detail {

/// A determinant: its sign is exact, its value is rounded and has that sign.
struct signed_value {
  double value = 0;
  int sign = 0;
};

signed_value exact_line_sign(const vec3& g, const vec3& a, const vec3& ax, const vec3& b, const vec3& bx);

/// A rounded determinant and a bound of its error.
struct rounded_value {
  double value, error;
};

/// det(g, u, w).
inline rounded_value rounded_line_sign(const vec3& g, const vec3& u, const vec3& w) {
  const double px = u.y * w.z, qx = u.z * w.y, py = u.z * w.x, qy = u.x * w.z, pz = u.x * w.y, qz = u.y * w.x;
  const double det = g.x * (px - qx) + g.y * (py - qy) + g.z * (pz - qz);
  const double size = std::abs(g.x) * (std::abs(px) + std::abs(qx)) + std::abs(g.y) * (std::abs(py) + std::abs(qy)) +
                      std::abs(g.z) * (std::abs(pz) + std::abs(qz));
  return {det, 8 * 0x1p-53 * size};
}

inline signed_value line_sign(const vec3& g, const vec3& u, const vec3& w, const vec3& a, const vec3& ax, const vec3& b,
                              const vec3& bx) {
  const rounded_value det = rounded_line_sign(g, u, w);
  if (det.value > det.error) return {det.value, 1};
  if (det.value < -det.error) return {det.value, -1};
  return exact_line_sign(g, a, ax, b, bx);
}

/// det(g, a - x, b - x): positive if the line through x along g passes a to b on the left, seen from where g points to.
inline signed_value side_of_line(const vec3& g, const vec3& a, const vec3& b, const vec3& x) {
  return line_sign(g, a - x, b - x, a, x, b, x);
}

/// det(g, a - x, n): positive if a lies to the left of the line through x along g in the plane with normal n, seen from
/// where n points to.
inline signed_value side_in_plane(const vec3& g, const vec3& a, const vec3& n, const vec3& x) {
  return line_sign(g, a - x, n, a, x, n, {});
}

inline double max_abs_component(const vec3& a) {
  return std::max(std::max(std::abs(a.x), std::abs(a.y)), std::abs(a.z));
}

/// The lexicographic order of points. It decides ties, so that results do not depend on the order of elements.
inline bool lies_before(const vec3& a, const vec3& b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// The vector area, twice, of a triangle; the same bits whichever corner comes first.
inline vec3 triangle_normal(const vec3& a, const vec3& b, const vec3& c) {
  const bool ab = lies_before(a, b), bc = lies_before(b, c), ca = lies_before(c, a);
  const vec3* const corners[] = {&a, &b, &c, &a, &b};
  // no branches: which corner comes first cannot be predicted
  const vec3* const* const first = corners + (ab && !ca ? 0 : bc && !ab ? 1 : 2);
  return cross(*first[1] - *first[0], *first[2] - *first[0]);
}

/// How far x lies inside a triangle, seen along its normal: the least distance from its sides, negative outside.
inline double depth_in_triangle(const vec3& x, const std::array<vec3, 3>& at, const vec3& normal) {
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const vec3 side = at[(k + 1) % 3] - at[k];
    depth = std::min(depth, dot(cross(side, x - at[k]), normal) / (norm(normal) * norm(side)));
  }
  return depth;
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/lines/detail/cells/line_signs.ipp>
#endif
