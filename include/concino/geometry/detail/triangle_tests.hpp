// Exact intersection predicates of triangles with segments, triangles and boxes. All include their boundaries.
#pragma once

#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/detail/crossing.hpp>

#include <array>

namespace concino::detail {

using triangle_points = std::array<vec3, 3>;

inline bool has_area(const triangle_points& t) {
  for (std::size_t k = 0; k < 3; ++k)
    if (orient2d(project_along(t[0], k), project_along(t[1], k), project_along(t[2], k)) != 0) return true;
  return false;
}

/// Whether two segments in the plane of x and y have a point in common.
inline bool segments_meet2d(const vec3& p, const vec3& q, const vec3& a, const vec3& b) {
  const int sp = orient2d(a, b, p), sq = orient2d(a, b, q), sa = orient2d(p, q, a), sb = orient2d(p, q, b);
  if (sp * sq < 0 && sa * sb < 0) return true;
  const auto on = [](int side, const vec3& u, const vec3& v, const vec3& x) {
    return side == 0 && std::min(u.x, v.x) <= x.x && x.x <= std::max(u.x, v.x) && std::min(u.y, v.y) <= x.y &&
           x.y <= std::max(u.y, v.y);
  };
  return on(sp, a, b, p) || on(sq, a, b, q) || on(sa, p, q, a) || on(sb, p, q, b);
}

/// Whether the segment from p to q and the triangle have a point in common. sp and sq: the orient3d of p and q relative
/// to its plane.
/// Needs: has_area(t).
inline bool segment_meets_triangle(const vec3& p, int sp, const vec3& q, int sq, const triangle_points& t) {
  if (sp * sq > 0) return false;
  if (sp != 0 || sq != 0) {  // the line through p and q crosses the plane between them: does it pass through the
                             // triangle?
    const int u = orient3d(p, q, t[0], t[1]), v = orient3d(p, q, t[1], t[2]), w = orient3d(p, q, t[2], t[0]);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const vec3 a = project_along(t[0], k), b = project_along(t[1], k), c = project_along(t[2], k);
    const int s = orient2d(a, b, c);
    if (s == 0) continue;
    const vec3 x = project_along(p, k), y = project_along(q, k);
    return inside2d(a, b, c, s, x) || segments_meet2d(x, y, a, b) || segments_meet2d(x, y, b, c) ||
           segments_meet2d(x, y, c, a);
  }
  return false;
}

/// The orientations of the corners of s relative to the plane of t.
inline std::array<int, 3> orientations_to_plane(const triangle_points& t, const triangle_points& s) {
  return {orient3d(t[0], t[1], t[2], s[0]), orient3d(t[0], t[1], t[2], s[1]), orient3d(t[0], t[1], t[2], s[2])};
}
inline bool all_on_one_side(const std::array<int, 3>& orientations) {
  return orientations[0] != 0 && orientations[0] == orientations[1] && orientations[1] == orientations[2];
}

/// Whether two triangles have a point in common.
/// Needs: both have area.      Source: they intersect only if an edge of one meets the other, as in Guigue and
///        Devillers 2003.
inline bool triangles_meet(const triangle_points& s, const triangle_points& t) {
  const auto of_s = orientations_to_plane(t, s);
  if (all_on_one_side(of_s)) return false;
  const auto of_t = orientations_to_plane(s, t);
  if (all_on_one_side(of_t)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = i < 2 ? i + 1 : 0;
    if (segment_meets_triangle(s[i], of_s[i], s[j], of_s[j], t) ||
        segment_meets_triangle(t[i], of_t[i], t[j], of_t[j], s))
      return true;
  }
  return false;
}

/// Whether the triangle, with or without area, and the box have a point in common, by the separating axis theorem.
/// Source: Akenine-Moller 2001, "Fast 3D triangle-box overlap testing", with exact predicates for the dot products.
inline bool triangle_meets_box(const triangle_points& t, const box& b) {
  const auto beyond = [&](std::size_t k) {
    return std::max({t[0][k], t[1][k], t[2][k]}) < b.min[k] || std::min({t[0][k], t[1][k], t[2][k]}) > b.max[k];
  };
  if (beyond(0) || beyond(1) || beyond(2)) return false;
  for (const vec3& p : t)
    if (b.min.x <= p.x && p.x <= b.max.x && b.min.y <= p.y && p.y <= b.max.y && b.min.z <= p.z && p.z <= b.max.z)
      return true;
  bool before = false, behind = false, through = false;  // box corners on the sides of the triangle's plane
  for (unsigned c = 0; c < 8 && !through; ++c) {
    const int s =
        orient3d(t[0], t[1], t[2], {c & 1 ? b.max.x : b.min.x, c & 2 ? b.max.y : b.min.y, c & 4 ? b.max.z : b.min.z});
    (s > 0 ? before : s < 0 ? behind : through) = true;
    through = through || (before && behind);
  }
  if (!through) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const vec3 p[3] = {project_along(t[0], k), project_along(t[1], k), project_along(t[2], k)},
               low = project_along(b.min, k), high = project_along(b.max, k);
    const vec3 corner[4] = {low, {high.x, low.y, 0}, high, {low.x, high.y, 0}};
    const int turn = orient2d(p[0], p[1], p[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const vec3 &from = p[i], &to = p[i < 2 ? i + 1 : 0];
      const int side = orient2d(from, to, corner[0]);
      if (side == 0 || side == turn) continue;  // separated only if all corners lie on the other side
      bool all = true;
      for (std::size_t c = 1; c < 4 && all; ++c) all = orient2d(from, to, corner[c]) == side;
      if (all) return false;
    }
  }
  return true;
}

}  // namespace concino::detail
