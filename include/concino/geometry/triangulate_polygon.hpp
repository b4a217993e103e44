// Triangulation of a polygon in space without new points, for drawing, areas and formats with triangles only.
#pragma once

#include <concino/core/lexicographic.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/detail/ear_clipper.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace concino {

/// Three corners of a polygon, counted from 0.
using polygon_triangle = std::array<std::uint32_t, 3>;

/// Triangulates one polygon after another and reuses its memory; use one object per thread.
class polygon_triangulator {
 public:
  /// Triangulates a polygon by diagonals.
  /// Needs:  the corners in cyclic order; concave, non-planar, collinear or repeated corners are allowed.
  /// Result: max(n, 2) - 2 triangles with the orientation of the polygon, valid until the next call. If the projection
  ///         of the polygon along its vector area is simple, none is inverted there and they cover it. If it is not
  ///         simple or has no area, they still join all corners. The triangles depend on the cycle of points alone:
  ///         neither on the corner that comes first nor on the direction.
  ///         Cost: O(n) for most; ears are looked up in a grid if n is large.
  /// Source: ear clipping, Meisters 1975; the plane is that of the vector area.
  std::span<const polygon_triangle> operator()(std::span<const vec3> corners) {
    planar_.start(false);
    const std::size_t n = corners.size();
    if (n < 3) return {};
    if (n == 3) {
      planar_.fan(3);
      return planar_.triangles();
    }
    const cycle by_points = order_by_points(corners);
    if (!flatten(ordered_)) planar_.fan(n);
    else planar_.cut();
    for (polygon_triangle& t : planar_.triangles()) {
      for (index& k : t) k = by_points.corner(k);
      if (by_points.backward) std::swap(t[1], t[2]);
    }
    return planar_.triangles();
  }

  /// Triangulates the projection of a polygon along z, by exact tests.
  /// Needs:  the corners in counter-clockwise order seen from above. Corners may be collinear, and edges may touch one
  ///         another, as at bridges to holes, which are passed twice; no two edges cross. Coordinates x and y as
  ///         orient2d needs them.
  /// Result: as operator(). All triangles are counter-clockwise seen from above, none is degenerate.      Cost: as
  ///         operator().
  /// Errors: none.
  /// Source: as operator(); Shewchuk 1997 for the tests.
  std::span<const polygon_triangle> from_above(std::span<const vec3> corners) {
    planar_.start(true);
    if (corners.size() < 3) return {};
    for (const vec3& p : corners) planar_.add(p.x, p.y);
    planar_.cut();
    return planar_.triangles();
  }

 private:
  using index = std::uint32_t;
  // The corners in turn from `first`.
  struct cycle {
    index first, size;
    bool backward;
    index corner(index k) const {
      return backward ? (first >= k ? first - k : first + size - k) : first + k < size ? first + k : first + k - size;
    }
  };
  detail::ear_clipper planar_;
  std::vector<vec3> ordered_;

  // Negative if a comes before b, positive if after.
  static int compare(const vec3& a, const vec3& b) {
    return core::is_lexicographically_less(a, b) ? -1 : core::is_lexicographically_less(b, a) ? 1 : 0;
  }

  // The first of the lexicographically smallest rotations. Source: Shiloach 1981, "Fast canonization of circular
  // strings".
  static cycle smallest_rotation(std::span<const vec3> corners, bool backward) {
    const auto n = static_cast<index>(corners.size());
    index i = 0, j = 1, k = 0;
    while (i < n && j < n && k < n) {
      const cycle a{backward ? n - 1 - i : i, n, backward}, b{backward ? n - 1 - j : j, n, backward};
      const int order = compare(corners[a.corner(k)], corners[b.corner(k)]);
      if (order == 0) {
        ++k;
        continue;
      }
      (order < 0 ? j : i) += k + 1;
      if (i == j) ++j;
      k = 0;
    }
    const index first = std::min(i, j);
    return {backward ? n - 1 - first : first, n, backward};
  }

  // Copies the corners to ordered_, in an order that follows from the points.
  cycle order_by_points(std::span<const vec3> corners) {
    const cycle a = smallest_rotation(corners, false), b = smallest_rotation(corners, true);
    int order = 0;
    for (index k = 0; k < a.size && order == 0; ++k) order = compare(corners[a.corner(k)], corners[b.corner(k)]);
    const cycle& smaller = order > 0 ? b : a;
    ordered_.clear();
    for (index k = 0; k < a.size; ++k) ordered_.push_back(corners[smaller.corner(k)]);
    return smaller;
  }

  // Projects to the plane of the vector area, scaled to about 1 to avoid overflow and underflow. False if there is no
  // such plane.
  bool flatten(std::span<const vec3> corners) {
    const vec3 o = corners[0];
    double size = 0;
    for (const vec3& p : corners)
      size = std::max({size, std::abs(p.x - o.x), std::abs(p.y - o.y), std::abs(p.z - o.z)});
    if (!(size > 0) || !std::isfinite(size)) return false;
    vec3 n;
    for (std::size_t i = 2; i < corners.size(); ++i) n += cross((corners[i - 1] - o) / size, (corners[i] - o) / size);
    const double length = norm(n);
    if (!(length > 0)) return false;
    n /= length;
    vec3 t = cross(n, std::abs(n.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0});
    t /= norm(t);
    const vec3 b = cross(n, t);
    for (const vec3& p : corners) {
      const vec3 d = (p - o) / size;
      planar_.add(dot(d, t), dot(d, b));
    }
    return true;
  }
};

/// The triangles of one polygon. For many polygons use a polygon_triangulator.
/// Needs:  as polygon_triangulator.
/// Result: as polygon_triangulator, as a vector of its own.
/// Cost:   as polygon_triangulator, and its working memory.
/// Errors: none.
/// Source: as polygon_triangulator.
inline std::vector<polygon_triangle> triangulate_polygon(std::span<const vec3> corners) {
  polygon_triangulator cut;
  const auto triangles = cut(corners);
  return {triangles.begin(), triangles.end()};
}

}  // namespace concino
