// Self-intersections of a surface, by exact tests: pairs of polys with more in common than shared verts and edges.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/geometry/detail/box_pairs.hpp>
#include <concino/geometry/detail/box_tree_build.hpp>
#include <concino/geometry/detail/polygon_pieces.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino {

namespace detail {

/// Whether the boxes of two triangles have no point in common.
inline bool are_apart(const triangle_points& s, const triangle_points& t) {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::max(std::max(s[0][k], s[1][k]), s[2][k]) < std::min(std::min(t[0][k], t[1][k]), t[2][k]) ||
        std::max(std::max(t[0][k], t[1][k]), t[2][k]) < std::min(std::min(s[0][k], s[1][k]), s[2][k]))
      return true;
  return false;
}

/// The coordinate axis along which the projection of a triangle has the largest area.
inline std::size_t widest_axis(const triangle_points& t) {
  const vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  std::size_t axis = 0;
  for (const std::size_t k : {1u, 2u})
    if (std::abs(n[k]) > std::abs(n[axis])) axis = k;
  return axis;
}

/// Whether, projected along axis k, the line of a side of s at corner i separates s and t. Corner j of t is the same
/// point as corner i.
inline bool are_separated_at_corner(const triangle_points& s, std::size_t i, const triangle_points& t, std::size_t j,
                                    std::size_t k) {
  const vec3 corner = project_along(s[i], k), d = project_along(t[(j + 1) % 3], k),
             e = project_along(t[(j + 2) % 3], k);
  for (const std::size_t offset : {1u, 2u}) {
    const vec3 along = project_along(s[(i + offset) % 3], k);
    const int here = orient2d(corner, along, project_along(s[(i + 3 - offset) % 3], k));
    if (here != 0 && orient2d(corner, along, d) == -here && orient2d(corner, along, e) == -here) return true;
  }
  return false;
}

/// Whether two triangles with area have a common point that is not on a common vert or edge. Corners at the same point
/// are common, whatever their indices. s_is_edge, t_is_edge: whether the side from a corner to the next is an edge of
/// the poly that contains the triangle.
template<class IsEdge, class OtherIsEdge>
bool meet_elsewhere(const triangle_points& s, const triangle_points& t, IsEdge&& s_is_edge, OtherIsEdge&& t_is_edge) {
  std::size_t shared = 0, own = 0, other = 0;  // own, other: position of the last common corner; with two of them, the
                                               // sums give the position of the third
  std::size_t sum = 0, other_sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (s[i] == t[j]) {
        ++shared;
        own = i;
        other = j;
        sum += i;
        other_sum += j;
      }
  if (shared == 0) return triangles_meet(s, t);
  if (shared == 3) return true;
  // most neighbours are nearly coplanar: a projection separates them with little work
  const std::size_t axis = widest_axis(s);
  if (shared == 1) {  // a further common point implies that the side opposite to the corner of one triangle meets the
                      // other triangle
    if (are_separated_at_corner(s, own, t, other, axis) || are_separated_at_corner(t, other, s, own, axis))
      return false;
    const auto opposite_side_meets = [](const triangle_points& x, std::size_t corner, const triangle_points& y) {
      const vec3 &p = x[(corner + 1) % 3], &q = x[(corner + 2) % 3];
      return segment_meets_triangle(p, orient3d(y[0], y[1], y[2], p), q, orient3d(y[0], y[1], y[2], q), y);
    };
    return opposite_side_meets(s, own, t) || opposite_side_meets(t, other, s);
  }
  const std::size_t third = 3 - sum, other_third = 3 - other_sum, from = (third + 1) % 3;
  // the common side is a diagonal of one poly, so the other meets its interior
  if (!s_is_edge(from) || !t_is_edge((other_third + 1) % 3)) return true;
  // are both on the same side of the common edge, and coplanar?
  for (const std::size_t k : {axis, (axis + 1) % 3, (axis + 2) % 3}) {
    const vec3 p = project_along(s[from], k), q = project_along(s[(from + 1) % 3], k);
    const int here = orient2d(p, q, project_along(s[third], k));
    if (here != 0)
      return orient2d(p, q, project_along(t[other_third], k)) == here &&
             orient3d(s[0], s[1], s[2], t[other_third]) == 0;
  }
  return false;
}

}  // namespace detail

/// Pairs of polys with a common point that is not on a common vert or edge: they cross, overlap in a plane, or one
/// touches the other with a vert on a face or an edge. Verts at the same point count as one, so seams of unmerged verts
/// are not intersections.
/// Needs:  Embedded SurfaceMesh; closed, open or non-manifold.
/// Result: each pair once, with the poly that comes first in polys(m) first, sorted in that order. Exact for triangles;
///         other polygons are the triangles of triangulate_polygon. Triangles without area have no interior and are
///         skipped.
/// Cost:   O(n log n) time if boxes of triangles overlap few others, in parallel; memory as bounding_tree.
/// Errors: invalid_mesh if a vert of a poly is not finite.
/// Source: the test of Guigue and Devillers 2003, with the exact predicates of Shewchuk 1997.
template<SurfaceMesh M>
  requires Embedded<M>
std::vector<std::pair<poly_t<M>, poly_t<M>>> self_intersections(const M& m) {
  detail::polygon_pieces<M> pieces(m);
  std::vector<std::uint32_t> order;
  const detail::box_tree boxes =
      detail::build_box_tree(pieces.size(), pieces.leaf_size, [&](std::size_t i) { return pieces.box_of(i); }, order);
  pieces.arrange(order);
  std::vector<unsigned char> flat(pieces.size());
  parallel_for(pieces.size(), [&](std::size_t i) { flat[i] = !detail::has_area(pieces.triangle(i)); });

  using pair = std::array<std::uint32_t, 2>;
  std::vector<std::vector<pair>> found;
  detail::box_pairs(boxes).for_each([&](std::size_t parts) { found.resize(parts); },
                                    [&](std::size_t part, std::uint32_t i, std::uint32_t j) {
                                      const std::uint32_t first = pieces.owner(i), second = pieces.owner(j);
                                      if (first == second || flat[i] || flat[j]) return;
                                      const detail::triangle_points s = pieces.triangle(i), t = pieces.triangle(j);
                                      if (detail::are_apart(s, t)) return;
                                      if (detail::meet_elsewhere(
                                              s, t, [&](std::size_t k) { return pieces.is_polygon_edge(i, k); },
                                              [&](std::size_t k) { return pieces.is_polygon_edge(j, k); }))
                                        found[part].push_back({std::min(first, second), std::max(first, second)});
                                    });

  std::vector<pair> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::vector<std::pair<poly_t<M>, poly_t<M>>> result;
  result.reserve(all.size());
  for (const auto& [first, second] : all) result.emplace_back(pieces.poly(first), pieces.poly(second));
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void self_intersections(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void self_intersections(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
