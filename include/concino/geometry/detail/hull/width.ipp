// Defines width.hpp. One of the two planes holds a face of the convex hull, or each of them holds an edge.
#pragma once

#include <concino/core/error.hpp>
#include <concino/geometry/convex_hull.hpp>
#include <concino/geometry/width.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace concino::detail {

/// An edge of a convex hull: a point of it, its direction, and the directions from it into its two faces.
struct hull_edge {
  std::uint32_t from, to;
  vec3 at, along, into_left, into_right;
};

/// The edges of a hull, each once, and the unit normals of its faces.
class hull_edges_and_normals {
 public:
  std::vector<hull_edge> edges;
  std::vector<vec3> normals;

  explicit hull_edges_and_normals(const surface_arrays& s) {
    std::vector<hull_edge> half;
    for (std::size_t f = 0; f < s.num_polys(); ++f) {
      const auto loop = std::span(s.verts).subspan(s.offsets[f], s.offsets[f + 1] - s.offsets[f]);
      vec3 doubled;
      for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        doubled += cross(s.points[loop[i].raw()] - s.points[loop[0].raw()],
                         s.points[loop[i + 1].raw()] - s.points[loop[0].raw()]);
      normals.push_back(unit_vector(doubled));
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t a = loop[i].raw(), b = loop[i + 1 == loop.size() ? 0 : i + 1].raw();
        const vec3 along = unit_vector(s.points[b] - s.points[a]), into = cross(normals.back(), along);
        half.push_back({std::min(a, b), std::max(a, b), s.points[a], along, into, into});
      }
    }
    std::sort(half.begin(), half.end(), [](const hull_edge& a, const hull_edge& b) {
      return a.from != b.from ? a.from < b.from : a.to < b.to;
    });
    for (std::size_t i = 0; i + 1 < half.size(); i += 2) {
      edges.push_back(half[i]);
      edges.back().into_right = half[i + 1].into_left;
    }
  }
};

/// Points are scaled to a size near 1 by the frame.
CONCINO_INLINE width_result width_of_points(std::span<const vec3> points) {
  const convex_hull_result hull = convex_hull(points);
  if (hull.dimension < 0) return {};
  const local_frame frame([&](auto&& visit) {
    for (const vec3& x : hull.surface.points) visit(x);
  });
  surface_arrays local = hull.surface;
  for (vec3& x : local.points) x = frame(x);
  if (hull.dimension < 3) {
    const vec3 n = hull.dimension == 2 ? hull_edges_and_normals(local).normals[0] : vec3{};
    if (hull.dimension == 2) return {0, n};
    const vec3 along = hull.dimension == 1 ? unit_vector(local.points[1] - local.points[0]) : vec3{1, 0, 0};
    return {0, unit_vector(cross(along, std::abs(along.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0}))};
  }
  const hull_edges_and_normals parts(local);
  double width = std::numeric_limits<double>::infinity();
  vec3 direction;
  const auto consider = [&](double w, const vec3& n) {
    if (w < width) width = w, direction = n;
  };
  for (const vec3& n : parts.normals) {
    double low = 0, high = -std::numeric_limits<double>::infinity();
    for (const vec3& x : local.points) low = std::min(low, dot(n, x)), high = std::max(high, dot(n, x));
    consider(high - low, n);
  }
  constexpr double rounding = 1e-14;
  const auto touches = [&](const hull_edge& e, const vec3& n) {  // the plane with outward normal n at the edge
    return dot(n, e.into_left) <= rounding && dot(n, e.into_right) <= rounding;
  };
  for (std::size_t i = 0; i < parts.edges.size(); ++i)
    for (std::size_t j = i + 1; j < parts.edges.size(); ++j) {
      const hull_edge &a = parts.edges[i], &b = parts.edges[j];
      const vec3 c = cross(a.along, b.along);
      const double length = norm(c);
      if (length <= 1e-9) continue;  // parallel edges are in planes of faces
      const vec3 n = dot(c, a.at - b.at) < 0 ? -c / length : c / length;
      if (touches(a, n) && touches(b, -n)) consider(dot(n, a.at - b.at), n);
    }
  return {frame.from_local(width, 1), direction};
}

CONCINO_INLINE width_result width_of_polygon(std::span<const vec3> points) {
  const core::flat_polygon flat(points);
  if (!flat.is_finite() || !(flat.area() > 0)) return {0, width_of_points(points).direction};
  const convex_hull_result hull = convex_hull(flat.corners());
  const auto corner = [&](std::size_t i) -> const vec3& {
    return hull.surface.points[hull.surface.verts[i % hull.surface.offsets[1]].raw()];
  };
  const std::size_t n = hull.surface.offsets[1];
  const bool is_left = cross(corner(1) - corner(0), corner(2) - corner(0)).z > 0;  // the first side seen from above
  double width = std::numeric_limits<double>::infinity();
  vec3 direction;
  std::size_t farthest = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const vec3 along = unit_vector(corner(i + 1) - corner(i));
    const vec3 inward = is_left ? vec3{-along.y, along.x, 0} : vec3{along.y, -along.x, 0};
    const auto height = [&](std::size_t k) { return dot(inward, corner(k) - corner(i)); };
    farthest = std::max(farthest, i + 1);
    while (farthest < i + n && height(farthest + 1) > height(farthest)) ++farthest;
    if (height(farthest) < width) width = height(farthest), direction = inward;
  }
  return {flat.to_space(width, 1), flat.direction_in_space(direction)};
}

}  // namespace concino::detail
