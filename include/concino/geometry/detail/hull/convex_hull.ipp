// Defines convex_hull.hpp. Points are added in random order to a hull of triangles, some of which may be coplanar. A
// triangle is visible from a point that is strictly outside of its plane, so no new triangle is degenerate. Coplanar
// triangles are joined at the end.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/lexicographic.hpp>
#include <concino/geometry/convex_hull.hpp>
#include <concino/geometry/detail/hull/hull_builder.hpp>
#include <concino/geometry/orientation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace concino::detail {

/// The two polygons of coplanar points, counter-clockwise in the plane of axes i and j, and clockwise.
inline hull_polygons hull_in_plane(std::span<const vec3> points, const std::array<std::size_t, 2>& axes) {
  const auto flat = [&](std::uint32_t p) { return vec3{points[p][axes[0]], points[p][axes[1]], 0}; };
  std::vector<std::uint32_t> order(points.size()), ring;
  for (std::uint32_t p = 0; p < order.size(); ++p) order[p] = p;
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return core::is_lexicographically_less(flat(a), flat(b)); });
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = ring.size();
    for (const std::uint32_t p : order) {
      while (ring.size() >= first + 2 && orient2d(flat(ring[ring.size() - 2]), flat(ring.back()), flat(p)) <= 0)
        ring.pop_back();
      ring.push_back(p);
    }
    ring.pop_back();
    std::reverse(order.begin(), order.end());
  }
  return {ring, {ring.rbegin(), ring.rend()}};
}

/// The distinct points, by the number of the first of equal ones, in a fixed random order. `scaled` are all points, of
/// size 1.
inline std::vector<std::uint32_t> distinct_in_random_order(std::span<const vec3> scaled) {
  std::vector<std::uint32_t> order(scaled.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (core::is_lexicographically_less(scaled[a], scaled[b])) return true;
    return !core::is_lexicographically_less(scaled[b], scaled[a]) && a < b;
  });
  order.erase(
      std::unique(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return scaled[a] == scaled[b]; }),
      order.end());
  std::uint64_t state = 1;
  for (std::size_t i = order.size(); i > 1; --i) {
    state = state * 6364136223846793005u + 1442695040888963407u;  // Knuth's linear congruential generator
    std::swap(order[i - 1], order[(state >> 33) % i]);
  }
  return order;
}

/// Numbers the corners by the input, and sorts the polygons.
inline void fill_hull(convex_hull_result& hull, std::span<const vec3> points, hull_polygons polygons) {
  std::vector<std::size_t>& corners = hull.corners;
  for (const auto& polygon : polygons) corners.insert(corners.end(), polygon.begin(), polygon.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  for (const std::size_t i : corners) hull.surface.points.push_back(points[i]);
  for (auto& polygon : polygons) {
    for (std::uint32_t& v : polygon)
      v = static_cast<std::uint32_t>(std::lower_bound(corners.begin(), corners.end(), v) - corners.begin());
    std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  }
  std::sort(polygons.begin(), polygons.end());
  hull.surface.offsets.assign(1, 0);
  for (const auto& polygon : polygons) {
    if (polygon.size() < 3) continue;
    for (const std::uint32_t v : polygon) hull.surface.verts.push_back(vert_id(v));
    hull.surface.offsets.push_back(static_cast<std::uint32_t>(hull.surface.verts.size()));
  }
}

/// Brings points that span a segment, a triangle and a tet to the front, as far as there are any. The dimension that
/// they span.
inline int move_simplex_to_front(std::vector<std::uint32_t>& order, std::span<const vec3> scaled) {
  if (order.size() < 2) return static_cast<int>(order.size()) - 1;
  const auto at = [&](std::size_t i) { return scaled[order[i]]; };
  std::size_t third = 2, fourth = 3;
  const auto collinear = [&](std::size_t i) {
    const auto axes = spanning_axes(at(0), at(1), at(i));
    return axes[0] == axes[1];
  };
  while (third < order.size() && collinear(third)) ++third;
  if (third >= order.size()) return 1;
  std::swap(order[2], order[third]);
  while (fourth < order.size() && orient3d(at(0), at(1), at(2), at(fourth)) == 0) ++fourth;
  if (fourth >= order.size()) return 2;
  std::swap(order[3], order[fourth]);
  return 3;
}

}  // namespace concino::detail

namespace concino {

CONCINO_INLINE convex_hull_result convex_hull(std::span<const vec3> points) {
  if (points.size() >= std::numeric_limits<std::uint32_t>::max())
    core::throw_joined<invalid_argument>({"convex_hull: there are ", points.size(), " points; 2^32 - 2 are the most"});
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_finite(points[i]))
      core::throw_joined<invalid_argument>({"convex_hull: point ", i, " is not finite; leave it out"});
    largest = std::max({largest, std::abs(points[i].x), std::abs(points[i].y), std::abs(points[i].z)});
  }
  const int exponent = largest > 0 ? -std::ilogb(largest) : 0;
  std::vector<vec3> scaled(points.begin(), points.end());
  for (vec3& x : scaled) x = {std::ldexp(x.x, exponent), std::ldexp(x.y, exponent), std::ldexp(x.z, exponent)};
  std::vector<std::uint32_t> order = detail::distinct_in_random_order(scaled);

  convex_hull_result hull;
  hull.dimension = detail::move_simplex_to_front(order, scaled);
  std::vector<vec3> ordered;
  for (const std::uint32_t i : order) ordered.push_back(scaled[i]);
  detail::hull_polygons polygons;
  if (hull.dimension == 3) {
    polygons = detail::hull_builder(ordered)();
  } else if (hull.dimension == 2) {
    polygons = detail::hull_in_plane(ordered, detail::spanning_axes(ordered[0], ordered[1], ordered[2]));
  } else if (hull.dimension >= 0) {  // the ends of the segment, as a polygon that has no area
    const auto less = [&](const vec3& a, const vec3& b) { return core::is_lexicographically_less(a, b); };
    const auto ends = std::minmax_element(ordered.begin(), ordered.end(), less);
    polygons = {{static_cast<std::uint32_t>(ends.first - ordered.begin()),
                 static_cast<std::uint32_t>(ends.second - ordered.begin())}};
  }
  for (auto& polygon : polygons)
    for (std::uint32_t& v : polygon) v = order[v];
  detail::fill_hull(hull, points, std::move(polygons));
  return hull;
}

}  // namespace concino
