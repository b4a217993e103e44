// An invariant that keeps an edited surface near another one.
#pragma once

#include <concino/edit/proposed_edit.hpp>
#include <concino/geometry/bounding_tree.hpp>

namespace concino {

/// Refuses edits of triangles that make one with a vert, an edge's midpoint or a centroid farther than `distance` from the surface of the tree. The tree must
/// outlive the invariant.
/// Needs:  a bounding_tree of a surface; a distance >= 0, in units of the mesh.
/// Result: an invariant for `keep`. Between these points a triangle may be farther away, by at most half the length of its longest edge.
/// Cost:   at each edit, seven queries for each of its new polys.
/// Errors: invalid_argument if the distance is negative or not a number, and from an edit of tets.
template<SurfaceMesh M>
invariant max_distance(const poly_tree<M>& tree, double distance) {
  if (!(distance >= 0)) core::throw_joined<invalid_argument>({"max_distance: the distance is negative or not a number; it must be at least 0"});
  return [&tree, distance](const proposed_edit& e) -> permission {
    if (e.corners_per_poly != 3) core::throw_joined<invalid_argument>({"max_distance: the edit is one of tets; it must be one of triangles"});
    const auto is_near = [&](const vec3& x) {
      const auto hit = tree.closest(x);
      return hit && hit.distance <= distance;
    };
    for (std::size_t k = 0; k < e.num_new_polys(); ++k) {
      const auto p = e.new_poly(k);
      const vec3 &a = e.points_after[p[0]], &b = e.points_after[p[1]], &c = e.points_after[p[2]];
      for (const vec3& x : {a, b, c, (a + b) / 2, (b + c) / 2, (c + a) / 2, (a + b + c) / 3})
        if (!is_near(x)) return {refusal::invariant, "max_distance: the new surface would be too far away"};
    }
    return {};
  };
}
template<SurfaceMesh M>
invariant max_distance(const poly_tree<M>&& tree, double distance) = delete;  // keep the tree in a variable

}  // namespace concino
