// Exact orientation predicates orient2d and orient3d: the sign of a determinant of points, independent of rounding.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/core/expansion.hpp>

#include <cmath>

namespace concino {

namespace detail {

/// Half the distance from 1 to the next double.
inline constexpr double unit_roundoff = 0x1p-53;

inline int orient2d_exactly(double ax, double ay, double bx, double by, double cx, double cy) {
  const auto left = product(core::difference(ax, cx), core::difference(by, cy)),
             right = product(core::difference(ay, cy), core::difference(bx, cx));
  return sum(left, minus(right)).sign();
}

inline int orient3d_exactly(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
  const core::expansion<2> ax = core::difference(a.x, d.x), ay = core::difference(a.y, d.y),
                           az = core::difference(a.z, d.z);
  const core::expansion<2> bx = core::difference(b.x, d.x), by = core::difference(b.y, d.y),
                           bz = core::difference(b.z, d.z);
  const core::expansion<2> cx = core::difference(c.x, d.x), cy = core::difference(c.y, d.y),
                           cz = core::difference(c.z, d.z);
  const auto under = [](const core::expansion<2>& px, const core::expansion<2>& py, const core::expansion<2>& qx,
                        const core::expansion<2>& qy) { return sum(product(px, qy), minus(product(py, qx))); };
  const auto first = product(under(bx, by, cx, cy), az), second = product(under(cx, cy, ax, ay), bz),
             third = product(under(ax, ay, bx, by), cz);
  return -sum(sum(first, second), third).sign();
}

}  // namespace detail

/// Whether a, b, c turn left (1), turn right (-1) or are collinear (0), in the plane of x and y.
/// Needs:  finite coordinates whose products neither overflow nor underflow: 0 or magnitudes from about 1e-140 to
///         1e150.
/// Result: exact.                                      Cost: a few operations; some hundred if the points are nearly
///         collinear.
/// Errors: none.
/// Source: Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust geometric predicates".
inline int orient2d(const vec3& a, const vec3& b, const vec3& c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x), det = left - right;
  const double bound = (3 + 16 * detail::unit_roundoff) * detail::unit_roundoff * (std::abs(left) + std::abs(right));
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return detail::orient2d_exactly(a.x, a.y, b.x, b.y, c.x, c.y);
}

/// Whether d lies on the side of the plane through a, b, c from which these are counter-clockwise (1), on the other
/// side (-1) or on it (0). It is the sign of the volume of the tet a, b, c, d in the standard order.
/// Needs:  finite coordinates whose triple products neither overflow nor underflow: 0 or magnitudes from about 1e-95 to
///         1e100.
/// Result: exact.                                      Cost: some dozen operations; some thousand if the points are
///         nearly coplanar.
/// Errors: none.
/// Source: Shewchuk 1997, as orient2d.
inline int orient3d(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
  const vec3 u = a - d, v = b - d, w = c - d;
  const double vwx = v.x * w.y, vwy = v.y * w.x, wux = w.x * u.y, wuy = w.y * u.x, uvx = u.x * v.y, uvy = u.y * v.x;
  const double det = u.z * (vwx - vwy) + v.z * (wux - wuy) + w.z * (uvx - uvy);
  const double size = (std::abs(vwx) + std::abs(vwy)) * std::abs(u.z) +
                      (std::abs(wux) + std::abs(wuy)) * std::abs(v.z) + (std::abs(uvx) + std::abs(uvy)) * std::abs(w.z);
  const double bound = (7 + 56 * detail::unit_roundoff) * detail::unit_roundoff * size;
  if (det > bound) return -1;
  if (det < -bound) return 1;
  return detail::orient3d_exactly(a, b, c, d);
}

}  // namespace concino
