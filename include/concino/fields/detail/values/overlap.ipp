// Common areas and volumes; see overlap.hpp.
#pragma once

#include <concino/fields/detail/values/overlap.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace concino::detail {

struct flat_point {
  double x, y;
};

inline double turn(const flat_point& a, const flat_point& b, const flat_point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The common area of two triangles: the first is cut by the edges of the second (Sutherland, Hodgman 1974), both
/// counter-clockwise.
CONCINO_INLINE double common_area_of_triangles(const std::array<flat_point, 3>& a, const std::array<flat_point, 3>& b) {
  std::array<flat_point, 8> loop{a[0], a[1], a[2]}, cut;
  std::size_t n = 3;
  for (std::size_t k = 0; k < 3 && n > 0; ++k) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const flat_point p = loop[i], q = loop[(i + 1) % n];
      const double at_p = turn(b[k], b[(k + 1) % 3], p), at_q = turn(b[k], b[(k + 1) % 3], q);
      if (at_p >= 0) cut[kept++] = p;
      if ((at_p < 0) != (at_q < 0)) {
        const double t = at_p / (at_p - at_q);
        cut[kept++] = {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
      }
    }
    std::swap(loop, cut);
    n = kept;
  }
  double doubled = 0;
  for (std::size_t i = 2; i < n; ++i) doubled += turn(loop[0], loop[i - 1], loop[i]);
  return doubled / 2;
}

CONCINO_INLINE double common_area(const signed_simplices& a, const signed_simplices& b) {
  if (!(dot(a.normal, b.normal) > 0) || b.parts.empty()) return 0;
  const vec3 normal = b.normal / norm(b.normal), origin = b.parts[0][0];
  vec3 right = cross(std::abs(normal.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0}, normal);
  right /= norm(right);
  const vec3 up = cross(normal, right);
  const auto flatten = [&](const std::array<vec3, 4>& part, std::array<flat_point, 3>& to) {
    for (std::size_t k = 0; k < 3; ++k) to[k] = {dot(part[k] - origin, right), dot(part[k] - origin, up)};
    if (turn(to[0], to[1], to[2]) >= 0) return 1;
    std::swap(to[1], to[2]);
    return -1;
  };
  double area = 0;
  std::array<flat_point, 3> s, t;
  for (const auto& part : b.parts) {
    const int sign = flatten(part, t);
    for (const auto& other : a.parts) area += sign * flatten(other, s) * common_area_of_triangles(s, t);
  }
  return std::max(area, 0.0);
}

/// A plane; the side of positive heights is the inside of a tet.
struct tet_side {
  vec3 normal, origin;
  double height(const vec3& x) const { return dot(normal, x - origin); }
};

inline double sixfold_volume(const std::array<vec3, 4>& t) { return dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])); }

/// Six times the volume of the part of a tet that is inside of the sides from `k` on.
CONCINO_INLINE double volume_inside(std::array<vec3, 4> t, const std::array<tet_side, 4>& sides, std::size_t k) {
  if (k == 4) return std::abs(sixfold_volume(t));
  std::array<double, 4> height;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < 4; ++i) {  // those inside come first
    height[i] = sides[k].height(t[i]);
    if (height[i] >= 0) {
      std::swap(height[i], height[inside]);
      std::swap(t[i], t[inside]);
      ++inside;
    }
  }
  if (inside == 0) return 0;
  if (inside == 4) return volume_inside(t, sides, k + 1);
  const auto cut = [&](std::size_t i, std::size_t j) {
    return t[i] + (height[i] / (height[i] - height[j])) * (t[j] - t[i]);
  };
  if (inside == 1) return volume_inside({t[0], cut(0, 1), cut(0, 2), cut(0, 3)}, sides, k + 1);
  const auto of_prism = [&](const std::array<vec3, 3>& p, const std::array<vec3, 3>& q) {
    return volume_inside({p[0], p[1], p[2], q[2]}, sides, k + 1) +
           volume_inside({p[0], p[1], q[1], q[2]}, sides, k + 1) +
           volume_inside({p[0], q[0], q[1], q[2]}, sides, k + 1);
  };
  if (inside == 3) return of_prism({cut(0, 3), cut(1, 3), cut(2, 3)}, {t[0], t[1], t[2]});
  return of_prism({t[0], cut(0, 2), cut(0, 3)}, {t[1], cut(1, 2), cut(1, 3)});
}

CONCINO_INLINE double common_volume(const signed_simplices& a, const signed_simplices& b) {
  double sixfold = 0;
  for (const auto& t : b.parts) {
    const double size = sixfold_volume(t);
    if (size == 0) continue;
    const double sign = size > 0 ? 1 : -1;
    std::array<tet_side, 4> sides;
    for (std::size_t i = 0; i < 4; ++i) {
      const vec3 origin = t[(i + 1) % 4], normal = cross(t[(i + 2) % 4] - origin, t[(i + 3) % 4] - origin);
      sides[i] = {dot(normal, t[i] - origin) < 0 ? -normal : normal, origin};
    }
    for (const auto& s : a.parts) {
      const bool is_apart = std::any_of(sides.begin(), sides.end(), [&](const tet_side& side) {
        return std::all_of(s.begin(), s.end(), [&](const vec3& x) { return side.height(x) <= 0; });
      });
      if (!is_apart) sixfold += (sixfold_volume(s) > 0 ? sign : -sign) * volume_inside(s, sides, 0);
    }
  }
  return std::abs(sixfold) / 6;
}

}  // namespace concino::detail
