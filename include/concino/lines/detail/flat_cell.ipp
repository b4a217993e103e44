// Defines flat_cell.hpp.
#pragma once

#include <concino/lines/detail/flat_cell.hpp>
#include <concino/lines/detail/line_signs.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

CONCINO_INLINE bool is_corner_of(std::uint32_t c, std::span<const std::uint32_t> entry) { return std::find(entry.begin(), entry.end(), c) != entry.end(); }

/// The side of the line on which a to b passes. A side of the triangle of entry is known: the line enters between its three sides.
CONCINO_INLINE signed_value side_of_entered_line(const flat_cell& cell, const vec3& x, const vec3& g, std::span<const std::uint32_t> entry, std::uint32_t a,
                                                 std::uint32_t b) {
  signed_value s = side_of_line(g, cell.points[a], cell.points[b], x);
  if (entry.size() == 3 && is_corner_of(a, entry) && is_corner_of(b, entry)) {
    const std::ptrdiff_t i = std::find(entry.begin(), entry.end(), a) - entry.begin();
    const int sign = entry[static_cast<std::size_t>((i + 1) % 3)] == b ? -1 : 1;
    if (s.sign != sign) s = {0, sign};
  }
  return s;
}

CONCINO_INLINE cell_exit exit_in(const flat_cell& cell, std::uint32_t t, const std::array<signed_value, 3>& s) {
  const cell_triangle& c = cell.triangles[t];
  const vec3 &p = cell.points[c.corner[0]], &q = cell.points[c.corner[1]], &r = cell.points[c.corner[2]];
  for (std::uint32_t k = 0; k < 3; ++k)
    if (s[k].sign == 0 && s[(k + 2) % 3].sign == 0) return {cell_exit::kind::corner, t, k, 0, cell.points[c.corner[k]]};
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (s[k].sign != 0) continue;
    const double a = s[(k + 1) % 3].value, b = s[(k + 2) % 3].value, parameter = a + b > 0 ? b / (a + b) : 0.5;
    const vec3 &from = cell.points[c.corner[k]], &to = cell.points[c.corner[(k + 1) % 3]];
    return {cell_exit::kind::side, t, k, parameter, from + parameter * (to - from)};
  }
  const double whole = s[0].value + s[1].value + s[2].value;
  return {cell_exit::kind::triangle, t, 0, 0, whole > 0 ? p + (s[2].value * (q - p) + s[0].value * (r - p)) / whole : (p + q + r) / 3};
}

/// Whether g certainly enters the cell where it crosses the triangle: most triangles are left out by this.
CONCINO_INLINE bool points_inward(const flat_cell& cell, const cell_triangle& c, const vec3& g) {
  const vec3 &p = cell.points[c.corner[0]], u = cell.points[c.corner[1]] - p, w = cell.points[c.corner[2]] - p;
  const double ax = u.y * w.z, bx = u.z * w.y, ay = u.z * w.x, by = u.x * w.z, az = u.x * w.y, bz = u.y * w.x;
  const double size = std::abs(g.x) * (std::abs(ax) + std::abs(bx)) + std::abs(g.y) * (std::abs(ay) + std::abs(by)) + std::abs(g.z) * (std::abs(az) + std::abs(bz));
  return g.x * (ax - bx) + g.y * (ay - by) + g.z * (az - bz) < -8 * 0x1p-53 * size;
}

CONCINO_INLINE cell_exit leave_cell(const flat_cell& cell, const vec3& x, const vec3& g, std::span<const std::uint32_t> entry) {
  cell_exit best;
  std::uint32_t found = 0;
  std::array<signed_value, 3> best_signs;
  double best_step = 0;
  const auto step_to = [&](std::uint32_t t) {
    const cell_triangle& c = cell.triangles[t];
    const vec3 &p = cell.points[c.corner[0]], n = cross(cell.points[c.corner[1]] - p, cell.points[c.corner[2]] - p);
    const double speed = dot(n, g);
    return speed > 0 ? dot(n, p - x) / speed : 0;
  };
  for (std::uint32_t t = 0; t < cell.triangles.size(); ++t) {
    const cell_triangle& c = cell.triangles[t];
    std::size_t met = 0;
    for (const std::uint32_t k : c.corner) met += is_corner_of(k, entry);
    if (!entry.empty() && met == entry.size()) continue;
    if (points_inward(cell, c, g)) continue;
    std::array<signed_value, 3> s;
    unsigned k = 0;
    bool turns = false;
    for (; k < 3; ++k) {
      s[k] = side_of_entered_line(cell, x, g, entry, c.corner[k], c.corner[(k + 1) % 3]);
      if (s[k].sign < 0) break;
      turns = turns || s[k].sign > 0;
    }
    if (k < 3 || !turns) continue;
    if (found++ == 0) {
      best.at = cell_exit::kind::triangle;
      best.triangle = t;
      best_signs = s;
      continue;
    }
    if (found == 2) best_step = step_to(best.triangle);
    const double step = step_to(t);
    if (best_step > 0 ? step > 0 && step < best_step : step > best_step) {
      best.triangle = t;
      best_signs = s;
      best_step = step;
    }
  }
  return found == 0 ? best : exit_in(cell, best.triangle, best_signs);
}

}  // namespace concino::detail
