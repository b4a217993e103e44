// Point location predicates by symbolic perturbation. The query point is moved by (e, e^2, e^3) for an
// infinitesimal e > 0. So it never lies on a line or plane, rays from it never meet an edge or a vert, and of polys
// that tile space exactly one contains it. Predicates for the unmoved point on a triangle are exact as well.
// Source: Edelsbrunner and Mucke 1990, "Simulation of simplicity".
#pragma once

#include <concino/geometry/orientation.hpp>

#include <algorithm>
#include <cstddef>

namespace concino::detail {

/// The projection of p along coordinate axis k: the other two coordinates, in cyclic order.
inline vec3 project_along(const vec3& p, std::size_t k) {
  return k == 0 ? vec3{p.y, p.z, 0} : k == 1 ? vec3{p.z, p.x, 0} : vec3{p.x, p.y, 0};
}

/// orient2d(a, b, x) for the moved x: 0 only if a and b are equal.
inline int perturbed_orient2d(const vec3& a, const vec3& b, const vec3& x) {
  if (const int s = orient2d(a, b, x)) return s;
  if (a.y != b.y) return a.y > b.y ? 1 : -1;
  return b.x > a.x ? 1 : b.x < a.x ? -1 : 0;
}

/// orient3d(a, b, c, x) for the moved x: 0 only if a, b, c are collinear.
inline int perturbed_orient3d(const vec3& a, const vec3& b, const vec3& c, const vec3& x) {
  if (const int s = orient3d(a, b, c, x)) return s;
  for (std::size_t k = 0; k < 3; ++k)  // the derivative with respect to x is the normal
    if (const int s = orient2d(project_along(a, k), project_along(b, k), project_along(c, k))) return s;
  return 0;
}

/// Whether the moved x lies in the triangle in the plane of x and y: 1 if the triangle runs counter-clockwise, -1 if
/// clockwise, 0 if x is outside.
inline int perturbed_inside2d(const vec3& a, const vec3& b, const vec3& c, const vec3& x) {
  if (std::max({a.x, b.x, c.x}) <= x.x || std::min({a.x, b.x, c.x}) > x.x) return 0;
  if (std::max({a.y, b.y, c.y}) <= x.y || std::min({a.y, b.y, c.y}) > x.y) return 0;
  const int s = perturbed_orient2d(a, b, x);
  return s != 0 && perturbed_orient2d(b, c, x) == s && perturbed_orient2d(c, a, x) == s ? s : 0;
}

/// How the ray from the moved x along z crosses the triangle: 1 if it leaves on the side from which the triangle is
/// counter-clockwise, -1 on the other side, 0 if it does not cross it. The sum over a closed surface is the winding
/// number around x.
inline int crossing_above(const vec3& a, const vec3& b, const vec3& c, const vec3& x) {
  if (std::max({a.z, b.z, c.z}) <= x.z) return 0;
  const int s = perturbed_inside2d(a, b, c, x);
  return s != 0 && (std::min({a.z, b.z, c.z}) > x.z || perturbed_orient3d(a, b, c, x) == -s) ? s : 0;
}

/// Whether the moved x lies in the tet, whatever its orientation. Equivalent to a winding number of its four faces.
inline bool perturbed_inside_tet(const vec3& a, const vec3& b, const vec3& c, const vec3& d, const vec3& x) {
  const int s = perturbed_orient3d(a, b, c, x);
  return s != 0 && perturbed_orient3d(a, c, d, x) == s && perturbed_orient3d(a, d, b, x) == s &&
         perturbed_orient3d(b, d, c, x) == s;
}

/// Whether the unmoved x lies in the triangle or on its boundary in the plane of x and y. The triangle must have area
/// (s, its orient2d, not 0).
inline bool inside2d(const vec3& a, const vec3& b, const vec3& c, int s, const vec3& x) {
  return s * orient2d(a, b, x) >= 0 && s * orient2d(b, c, x) >= 0 && s * orient2d(c, a, x) >= 0;
}

/// Whether the unmoved x is a point of the triangle, boundary included; a triangle without area is a segment or a
/// point.
inline bool is_on_triangle(const vec3& a, const vec3& b, const vec3& c, const vec3& x) {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::max({a[k], b[k], c[k]}) < x[k] || std::min({a[k], b[k], c[k]}) > x[k]) return false;
  if (orient3d(a, b, c, x) != 0) return false;
  bool on_line = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const vec3 p = project_along(a, k), q = project_along(b, k), r = project_along(c, k), y = project_along(x, k);
    if (const int s = orient2d(p, q, r)) return inside2d(p, q, r, s, y);
    on_line = on_line && orient2d(p, q, y) == 0 && orient2d(q, r, y) == 0 && orient2d(r, p, y) == 0;
  }
  return on_line;  // and in the bounding box of a segment
}

}  // namespace concino::detail
