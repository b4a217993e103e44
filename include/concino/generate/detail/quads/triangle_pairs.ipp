// Bodies of triangle_pairs.hpp: joins triangles in pairs to quads.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/generate/detail/quads/maximum_matching.hpp>
#include <concino/generate/detail/quads/triangle_pairs.hpp>
#include <concino/geometry/corner_angles.hpp>

#include <algorithm>
#include <numbers>
#include <utility>

namespace concino::detail {

/// Corner i and the corners after and before it in its triangle.
struct triangle_corner {
  std::size_t i, next, previous;
  explicit triangle_corner(std::size_t corner)
      : i(corner), next(corner % 3 == 2 ? corner - 2 : corner + 1),
        previous(corner % 3 == 0 ? corner + 2 : corner - 1) {}
};

/// For each corner the corner of another triangle with the same edge in the opposite direction, if no other triangle
/// has this edge and the two share no other vert; otherwise `none`.
CONCINO_INLINE std::vector<std::uint32_t> opposite_corners(const triangle_list& list) {
  constexpr std::uint32_t none = augmenting_paths::none, several = none - 1;
  std::vector<std::uint32_t> first(list.num_edges, none), opposite(list.edges.size(), none);
  for (std::uint32_t i = 0; i < list.edges.size(); ++i) {
    std::uint32_t& of_edge = first[list.edges[i]];
    if (of_edge == none) {
      of_edge = i;
    } else if (of_edge != several && opposite[of_edge] == none) {
      opposite[of_edge] = i, opposite[i] = of_edge;
    } else if (of_edge != several) {
      opposite[opposite[of_edge]] = none, opposite[of_edge] = none;
      of_edge = several;
    }
  }
  for (std::uint32_t i = 0; i < opposite.size(); ++i) {
    if (opposite[i] == none) continue;
    const std::uint32_t j = opposite[i];
    const triangle_corner one(i), other(j);
    const bool in_order = list.verts[i] == list.verts[other.next] && list.verts[j] == list.verts[one.next];
    if (!in_order || list.verts[one.previous] == list.verts[other.previous]) opposite[i] = opposite[j] = none;
  }
  return opposite;
}

/// The angles at all corners, in radians.
CONCINO_INLINE std::vector<double> triangle_angles(const triangle_list& list) {
  std::vector<double> angles(list.verts.size());
  parallel_for(angles.size(), [&](std::size_t i) {
    const triangle_corner c(i);
    angles[i] = angle_at_corner(list.points[list.verts[c.previous].raw()], list.points[list.verts[i].raw()],
                                list.points[list.verts[c.next].raw()], {});
  });
  return angles;
}

/// A pair of triangles, by the corner of the first one at the edge that they share.
struct scored_pair {
  double deviation;  // the largest difference of a corner of the quad from a right angle
  std::uint32_t corner;
  bool operator<(const scored_pair& o) const {
    return deviation != o.deviation ? deviation < o.deviation : corner < o.corner;
  }
};

/// The pairs that may be joined, from the best one; the others are removed from `opposite`.
CONCINO_INLINE std::vector<scored_pair> convex_pairs(const triangle_list& list, double max_angle,
                                                     std::vector<std::uint32_t>& opposite) {
  constexpr std::uint32_t none = augmenting_paths::none;
  const std::vector<double> angles = triangle_angles(list);
  std::vector<scored_pair> pairs;
  pairs.reserve(opposite.size() / 2);
  for (std::uint32_t i = 0; i < opposite.size(); ++i) {
    const std::uint32_t j = opposite[i];
    if (j == none || j < i) continue;
    const triangle_corner a(i), b(j);
    const double quad[] = {angles[a.i] + angles[b.next], angles[a.next] + angles[b.i], angles[a.previous],
                           angles[b.previous]};
    const auto [least, most] = std::minmax_element(quad, quad + 4);
    const double smallest = std::min({angles[a.i], angles[a.next], angles[b.i], angles[b.next], *least});
    constexpr double right = std::numbers::pi / 2;
    // triangles without area have angles of 0
    if (smallest > 0 && *most < max_angle - 1e-9) pairs.push_back({std::max(*most - right, right - *least), i});
    else opposite[i] = opposite[j] = none;
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// For each triangle the one that it is joined with, or `none`: the best pairs first, then as many as possible.
CONCINO_INLINE std::vector<std::uint32_t> matched_triangles(const std::vector<scored_pair>& pairs,
                                                            const std::vector<std::uint32_t>& opposite) {
  constexpr std::uint32_t none = augmenting_paths::none;
  std::vector<std::uint32_t> mate(opposite.size() / 3, none), neighbours(opposite.size(), none);
  for (const scored_pair& p : pairs) {
    const std::uint32_t a = p.corner / 3, b = opposite[p.corner] / 3;
    if (mate[a] == none && mate[b] == none) mate[a] = b, mate[b] = a;
  }
  for (std::size_t i = 0; i < opposite.size(); ++i)
    if (opposite[i] != none) neighbours[i] = opposite[i] / 3;
  augmenting_paths(neighbours, mate).augment();
  return mate;
}

/// The areas of two triangles with a common edge, up to a common factor: their heights above it.
CONCINO_INLINE std::pair<double, double> heights(const triangle_list& list, const triangle_corner& a,
                                                 const triangle_corner& b) {
  const auto at = [&](std::size_t corner) { return list.points[list.verts[corner].raw()]; };
  const vec3 start = at(a.i), along = (at(a.next) - start) / distance(at(a.next), start);
  const auto height = [&](const vec3& top) {
    const double length = distance(top, start);
    return length * norm(cross(along, (top - start) / length));
  };
  return {height(at(a.previous)), height(at(b.previous))};
}

CONCINO_INLINE joined_triangles join_triangles(triangle_list&& list, double max_angle) {
  constexpr std::uint32_t none = augmenting_paths::none;
  std::vector<std::uint32_t> opposite = opposite_corners(list);
  const std::vector<std::uint32_t> mate = matched_triangles(convex_pairs(list, max_angle, opposite), opposite);
  joined_triangles result;
  surface_arrays& a = result.polygons;
  a.offsets.push_back(0);
  for (std::uint32_t t = 0; t < mate.size(); ++t) {
    if (mate[t] != none && mate[t] < t) continue;
    const auto corner = [&](std::size_t i) { return list.verts[i]; };
    if (mate[t] == none) {
      result.triangles.push_back(poly_id{a.offsets.size() - 1});
      a.verts.insert(a.verts.end(), {corner(3 * t), corner(3 * t + 1), corner(3 * t + 2)});
      result.from.add(list.polys[t]);
    } else {
      std::size_t i = 3 * std::size_t{t};
      while (opposite[i] == none || opposite[i] / 3 != mate[t]) ++i;
      const triangle_corner one(i), other(opposite[i]);
      a.verts.insert(a.verts.end(), {corner(one.i), corner(other.previous), corner(one.next), corner(one.previous)});
      const auto [h, k] = heights(list, one, other);
      result.from.add({{list.polys[t], h}, {list.polys[mate[t]], k}});
    }
    a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  }
  a.points = std::move(list.points);
  return result;
}

}  // namespace concino::detail
