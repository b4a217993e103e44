// The crossing of a polygon by a level set; see polygon_crossings.hpp.
#pragma once

#include <concino/core/local_numbers.hpp>
#include <concino/level_sets/detail/cut/polygon_crossings.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

/// Whether all turns at the corners of a quad are to the left, without a tolerance.
inline bool turns_left(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
  const vec3 ab = b - a, bc = c - b, cd = d - c, da = a - d, normal = cross(ab, c - a) + cross(c - a, d - a);
  return dot(cross(da, ab), normal) >= 0 && dot(cross(ab, bc), normal) >= 0 && dot(cross(bc, cd), normal) >= 0 &&
         dot(cross(cd, da), normal) >= 0;
}

CONCINO_INLINE bool is_convex_polygon(std::span<const vec3> corners) {
  const std::size_t n = corners.size();
  if (n < 4 || (n == 4 && turns_left(corners[0], corners[1], corners[2], corners[3]))) return true;
  vec3 normal, previous = corners[1] - corners[0];
  for (std::size_t i = 2; i < n; ++i) {
    const vec3 step = corners[i] - corners[0];
    normal += cross(previous, step);
    previous = step;
  }
  vec3 before = corners[0] - corners[n - 1];
  for (std::size_t i = 0; i < n; ++i) {
    const vec3 after = corners[i + 1 < n ? i + 1 : 0] - corners[i];
    const double turn = dot(cross(before, after), normal);
    if (turn < 0 && turn < -1e-14 * norm(normal) * norm(before) * norm(after)) return false;
    before = after;
  }
  return true;
}

CONCINO_INLINE bool is_planar_polygon(std::span<const vec3> corners) {
  vec3 mean, normal, previous;
  double size = 0, farthest = 0;  // largest coordinates, relative to the first corner and to the origin
  for (const vec3& x : corners) {
    const vec3 step = x - corners[0];
    normal += cross(previous, step);
    mean += step;
    previous = step;
    size = std::max({size, std::abs(step.x), std::abs(step.y), std::abs(step.z)});
    farthest = std::max({farthest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  }
  mean /= static_cast<double>(corners.size());
  const double tolerance = (1e-14 * size + 1e-15 * farthest) * norm(normal);
  for (const vec3& x : corners)
    if (std::abs(dot(x - corners[0] - mean, normal)) > tolerance) return false;
  return true;
}

CONCINO_INLINE bool mean_is_above(std::span<const double> values, double level) {
  double sum = 0;
  for (const double x : values) sum += x;
  const double n = static_cast<double>(values.size());
  if (std::isfinite(sum)) return sum / n >= level;
  sum = 0;
  for (const double x : values) sum += x / n;
  return sum >= level;
}

CONCINO_INLINE void polygon_crossings::find(std::span<const unsigned char> above, std::span<const double> values,
                                            std::span<const vec3> points, double level, std::uint32_t start) {
  chords_.clear(), inner_.clear(), crossed_.clear();
  const auto n = static_cast<std::uint32_t>(above.size());
  for (std::uint32_t k = 0; k < n; ++k)
    if (above[k] != above[k + 1 < n ? k + 1 : 0]) crossed_.push_back(k);
  if (crossed_.empty()) return;
  if (!is_convex_polygon(points)) cross_triangles(above, points, start);
  else cut_off_runs(above, crossed_.size() > 2 && mean_is_above(values, level));
}

/// A run of corners begins behind one crossed edge and ends before the next. Of two runs, either can be cut off.
CONCINO_INLINE void polygon_crossings::cut_off_runs(std::span<const unsigned char> above, bool centre_is_above) {
  const std::size_t n = crossed_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t before = crossed_[i], after = crossed_[i + 1 < n ? i + 1 : 0];
    const bool run_is_above = !above[before];
    if (run_is_above == centre_is_above) continue;
    if (run_is_above) chords_.push_back({after, before, 0, 0});
    else chords_.push_back({before, after, 0, 0});
  }
}

/// The other crossed edge of the triangle of `edge`. Edge 3 t + k of triangle t joins its corners k and k + 1.
CONCINO_INLINE std::uint32_t polygon_crossings::next_crossed_edge(std::span<const unsigned char> above,
                                                                  std::uint32_t edge) const {
  const std::uint32_t t = edge / 3, k = edge % 3;
  return 3 * t + (above[edges_[3 * t + (k + 1) % 3]] != above[edges_[3 * t + (k + 2) % 3]] ? k + 1 : k + 2) % 3;
}

/// Sets the first corner of each edge of each triangle, and the other edge of the same two corners, if it is a
/// diagonal. Then the edge of a triangle that is each edge of the polygon.
CONCINO_INLINE void polygon_crossings::link_triangles(std::span<const polygon_triangle> triangles, std::uint32_t start,
                                                      std::uint32_t n) {
  const auto num_edges = static_cast<std::uint32_t>(3 * triangles.size());
  edges_.clear();
  mates_.assign(num_edges + n, none);
  core::local_numbers diagonals;
  std::vector<std::uint32_t> first_edge;
  for (const polygon_triangle& t : triangles)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto edge = static_cast<std::uint32_t>(edges_.size());
      const std::uint32_t a = (t[k] + start) % n, b = (t[(k + 1) % 3] + start) % n;
      edges_.push_back(a);
      if (b == (a + 1) % n) {
        mates_[num_edges + a] = edge;
        continue;
      }
      const unsigned number = diagonals.add(std::size_t{a < b ? a : b} * n + (a < b ? b : a));
      if (number == first_edge.size()) {
        first_edge.push_back(edge);
      } else {
        mates_[edge] = first_edge[number];
        mates_[first_edge[number]] = edge;
      }
    }
}

CONCINO_INLINE void polygon_crossings::cross_triangles(std::span<const unsigned char> above,
                                                       std::span<const vec3> points, std::uint32_t start) {
  const auto n = static_cast<std::uint32_t>(above.size());
  rotated_.clear();
  for (std::uint32_t k = 0; k < n; ++k) rotated_.push_back(points[(start + k) % n]);
  link_triangles(triangulate_(rotated_), start, n);
  const auto num_edges = static_cast<std::uint32_t>(edges_.size());
  for (const std::uint32_t k : crossed_) {
    if (!above[k]) continue;
    const auto begin = static_cast<std::uint32_t>(inner_.size());
    std::uint32_t edge = next_crossed_edge(above, mates_[num_edges + k]);
    for (; mates_[edge] != none; edge = next_crossed_edge(above, mates_[edge])) {
      const std::uint32_t a = edges_[edge], b = edges_[edge % 3 == 2 ? edge - 2 : edge + 1];
      inner_.push_back(above[a] ? crossed_diagonal{b, a} : crossed_diagonal{a, b});
    }
    chords_.push_back({k, edges_[edge], begin, static_cast<std::uint32_t>(inner_.size())});
  }
}

}  // namespace concino::detail
