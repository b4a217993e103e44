// A convex part of a triangle, and how far it is from a set of triangles. The distance from a triangle is a convex
// function, so on a convex polygon it is largest at a corner. That gives an upper bound for each part from any of the
// triangles near it.
#pragma once

#include <concino/core/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace concino::core {

/// A convex part of a triangle. The squared distances of its points are at most `upper`.
struct polygon_part {
  static constexpr unsigned max_corners = 10;
  static constexpr double unit = 0x1p-46;  // distances are no more exact than this, in coordinates of at most 1

  std::array<vec3, max_corners> corners;
  unsigned n = 0;
  std::size_t candidate = 0;  // the triangle nearest to the mean of the corners
  double upper = std::numeric_limits<double>::infinity();

  bool operator<(const polygon_part& other) const { return upper < other.upper; }
  void add(const vec3& x) { corners[n++] = x; }
  vec3 mean() const {
    vec3 sum;
    for (unsigned k = 0; k < n; ++k) sum += corners[k];
    return sum / n;
  }

  /// Finds the candidate and the bounds that follow from it. Returns the squared distance of the mean.
  ///
  /// to: nearest(x, guess) is a triangle and its squared distance, triangle(i) the points of one, squared_distance(x,
  /// i) that of x from one.
  template<class Triangles>
  double bound(const Triangles& to, std::size_t guess) {
    const vec3 x = mean();
    const auto found = to.nearest(x, guess);
    candidate = found.triangle;
    double most = 0, reach = 0;
    for (unsigned k = 0; k < n; ++k) {
      most = std::max(most, to.squared_distance(corners[k], candidate));
      reach = std::max(reach, distance(x, corners[k]));
    }
    const double around = std::sqrt(found.squared) + reach;
    upper = std::min({upper, most, around * around});
    return found.squared;
  }

  /// Splits at the plane through `at` with normal m: what is behind it and what is before it. Both are empty if up to
  /// rounding all corners are on one side.
  std::array<polygon_part, 2> split(const vec3& at, const vec3& m) const {
    std::array<polygon_part, 2> sides;
    for (polygon_part& p : sides) p.upper = upper, p.candidate = candidate;
    const auto height = [&](const vec3& x) { return dot(x - at, m); };
    double least = 0, most = 0;
    for (unsigned k = 0; k < n; ++k)
      least = std::min(least, height(corners[k])), most = std::max(most, height(corners[k]));
    if (!(std::min(-least, most) > unit * norm(m))) return sides;
    for (unsigned k = 0; k < n; ++k) {
      const vec3 &x = corners[k], &y = corners[k + 1 < n ? k + 1 : 0];
      const double hx = height(x), hy = height(y);
      if (hx <= 0) sides[0].add(x);
      if (hx >= 0) sides[1].add(x);
      if ((hx < 0 && hy > 0) || (hx > 0 && hy < 0)) {
        const vec3 between = x + hx / (hx - hy) * (y - x);
        for (polygon_part& p : sides) p.add(between);
      }
    }
    return sides;
  }
  /// Splits at the edges of its candidate t, seen along the normal of that, and calls take(part) for each part outside.
  /// The part above the candidate remains; it has no other bound than its distance from it. Returns false if that
  /// splits nothing.
  template<class F>
  bool split_at(const std::array<vec3, 3>& t, const F& take) {
    const vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
    bool any = false;
    for (std::size_t k = 0; k < 3 && n + 1 < max_corners; ++k) {
      auto [inside, outside] = split(t[k], cross(t[k == 2 ? 0 : k + 1] - t[k], normal));
      if (inside.n < 3 || outside.n < 3) continue;
      take(outside);
      *this = inside;
      any = true;
    }
    return any;
  }
  /// Splits into halves of about equal length.
  std::array<polygon_part, 2> halves() const {
    unsigned i = 0, j = 1;
    for (unsigned k = 0; k < n; ++k)
      for (unsigned l = k + 1; l < n; ++l)
        if (distance(corners[k], corners[l]) > distance(corners[i], corners[j])) i = k, j = l;
    return split((corners[i] + corners[j]) / 2, corners[j] - corners[i]);
  }
};

}  // namespace concino::core
