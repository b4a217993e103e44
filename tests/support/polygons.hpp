// Polygons in the plane z = 0 for tests: regular ones, combs, stars, spirals, and random ones that are simple.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/geometry/orientation.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace concino::testing {

inline std::vector<vec3> regular_polygon(std::size_t n, double radius = 1) {
  std::vector<vec3> x;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    x.push_back({radius * std::cos(a), radius * std::sin(a), 0});
  }
  return x;
}

/// n teeth of width 1 and height h, at distances of 1, on a bar of height 1.
inline std::vector<vec3> comb_polygon(std::size_t n, double h) {
  const double width = 2 * static_cast<double>(n) - 1;
  std::vector<vec3> x{{0, -1, 0}, {width, -1, 0}};
  for (std::size_t i = n; i-- > 0;) {
    const double left = 2 * static_cast<double>(i);
    x.push_back({left + 1, h, 0});
    x.push_back({left, h, 0});
    if (i > 0) x.push_back({left, 0, 0}), x.push_back({left - 1, 0, 0});
  }
  return x;
}

/// A star with n tips at distance 1 and corners between them at distance r.
inline std::vector<vec3> star_polygon(std::size_t n, double r) {
  auto x = regular_polygon(2 * n);
  for (std::size_t i = 1; i < x.size(); i += 2) x[i] *= r;
  return x;
}

/// A corridor of width 1 that turns by right angles, n times.
inline std::vector<vec3> spiral_polygon(std::size_t n) {
  std::vector<vec3> middle{{0, 0, 0}}, left, right;
  double length = 2;
  const vec3 directions[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (std::size_t i = 0; i < n; ++i) {
    middle.push_back(middle.back() + length * directions[i % 4]);
    if (i % 2 == 1) length += 2;
  }
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const vec3 in = directions[(i + 3) % 4], out = directions[i % 4], before = i == 0 ? vec3{} : in, after = i + 1 == middle.size() ? vec3{} : out;
    const vec3 to_left = 0.5 * vec3{-before.y - after.y, before.x + after.x, 0};
    left.push_back(middle[i] + to_left);
    right.push_back(middle[i] - to_left);
  }
  right.insert(right.end(), left.rbegin(), left.rend());
  return right;
}

inline bool do_edges_cross(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
  return orient2d(a, b, c) * orient2d(a, b, d) <= 0 && orient2d(c, d, a) * orient2d(c, d, b) <= 0;
}

/// Random points in the unit square, joined by a simple polygon: crossings are undone until there are none.
inline std::vector<vec3> random_polygon(std::mt19937& random, std::size_t n) {
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<vec3> x;
  for (std::size_t i = 0; i < n; ++i) x.push_back({coordinate(random), coordinate(random), 0});
  for (bool any = true; any;) {
    any = false;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 2; j < n; ++j) {
        if (i == 0 && j + 1 == n) continue;
        if (!do_edges_cross(x[i], x[i + 1], x[j], x[(j + 1) % n])) continue;
        std::reverse(x.begin() + static_cast<std::ptrdiff_t>(i) + 1, x.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        any = true;
      }
  }
  double doubled = 0;
  for (std::size_t i = 0; i < n; ++i) doubled += cross(x[i], x[(i + 1) % n]).z;
  if (doubled < 0) std::reverse(x.begin(), x.end());
  return x;
}

/// The distance of x from the boundary of a polygon; negative outside.
inline double depth_in_polygon(const std::vector<vec3>& polygon, const vec3& x) {
  bool inside = false;
  double squared = 1e300;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const vec3 &a = polygon[i], &b = polygon[j];
    if ((a.y > x.y) != (b.y > x.y)) inside ^= x.x < a.x + (x.y - a.y) / (b.y - a.y) * (b.x - a.x);
    const double ex = b.x - a.x, ey = b.y - a.y, dx = x.x - a.x, dy = x.y - a.y;
    const double t = std::clamp((dx * ex + dy * ey) / (ex * ex + ey * ey), 0.0, 1.0);
    squared = std::min(squared, (dx - t * ex) * (dx - t * ex) + (dy - t * ey) * (dy - t * ey));
  }
  return inside ? std::sqrt(squared) : -std::sqrt(squared);
}

}  // namespace concino::testing
