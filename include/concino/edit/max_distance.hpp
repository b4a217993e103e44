// An invariant that keeps an edited surface near another one, and near what it was before the edit.
#pragma once

#include <concino/edit/proposed_edit.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/geometry/closest_point.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace concino {

namespace detail {

/// The corners of a triangle, the midpoints of its edges and its centroid.
inline std::array<vec3, 7> seven_points(std::span<const unsigned> triangle, std::span<const vec3> points) {
  const vec3 &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
  return {a, b, c, (a + b) / 2, (b + c) / 2, (c + a) / 2, (a + b + c) / 3};
}

/// Whether x is no farther than this from one of the new triangles. Scaled by a power of two, so that products neither
/// overflow nor underflow.
inline bool is_near_new(const proposed_edit& e, const vec3& x, double distance_allowed) {
  double largest = 0;
  for (const vec3& y : e.points_after) largest = std::max({largest, std::abs(y.x), std::abs(y.y), std::abs(y.z)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double scale = std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
  for (std::size_t k = 0; k < e.num_new_polys(); ++k) {
    const auto t = e.new_poly(k);
    const vec3 nearest = closest_point(scale * x, scale * e.points_after[t[0]], scale * e.points_after[t[1]],
                                       scale * e.points_after[t[2]]);
    if (distance(scale * x, nearest) <= scale * distance_allowed) return true;
  }
  return false;
}

}  // namespace detail

/// Refuses edits of triangles that make one with a vert, an edge's midpoint or a centroid farther than `distance` from
/// the surface of the tree. It also refuses those that replace a triangle with such a point farther than that from all
/// new ones, as where a corner of an open surface would vanish. The tree must outlive the invariant.
/// Needs:  a bounding_tree of a surface; a distance >= 0, in units of the mesh.
/// Result: an invariant for `keep`. Between these points a triangle may be farther away, by at most half the length of
///         its longest edge. Each edit may take something from an open surface; decimate with max_error bounds all its
///         edits together.
/// Cost:   at each edit, seven queries for each of its new polys, and the distances between its old and its new polys.
/// Errors: invalid_argument if the distance is negative or not a number, and from an edit of other polys than
///         triangles.
template<SurfaceMesh M>
invariant max_distance(const poly_tree<M>& tree, double distance) {
  if (!(distance >= 0))
    core::throw_joined<invalid_argument>(
        {"max_distance: the distance is negative or not a number; it must be at least 0"});
  return [&tree, distance](const proposed_edit& e) -> permission {
    if (e.corners_per_poly != 3)
      core::throw_joined<invalid_argument>(
          {"max_distance: the edit is one of tets or of larger polys; it must be one of triangles"});
    const auto is_near = [&](const vec3& x) {
      const auto hit = tree.closest(x);
      return hit && hit.distance <= distance;
    };
    for (std::size_t k = 0; k < e.num_new_polys(); ++k)
      for (const vec3& x : detail::seven_points(e.new_poly(k), e.points_after))
        if (!is_near(x)) return {refusal::invariant, "max_distance: the new surface would be too far away"};
    for (std::size_t k = 0; k < e.num_old_polys(); ++k)
      for (const vec3& x : detail::seven_points(e.old_poly(k), e.points_before))
        if (!detail::is_near_new(e, x, distance))
          return {refusal::invariant, "max_distance: the edit would remove a part that is not near the new surface"};
    return {};
  };
}
template<SurfaceMesh M>
invariant max_distance(const poly_tree<M>&& tree, double distance) = delete;  // keep the tree in a variable

}  // namespace concino
