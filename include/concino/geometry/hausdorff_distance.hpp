// How far two surfaces are apart: the largest distance of a point of one from the other.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/geometry/detail/polygon_pieces.hpp>

#include <cstddef>
#include <vector>

namespace concino {

/// A distance lies between these two.
struct distance_bounds {
  double lower = 0;
  double upper = 0;
};

struct hausdorff_options {
  double tolerance = 0.01;  // in [0, 1): the bounds are refined until they differ by at most this part of the upper one
  double max_cuts = 20;     // and until parts of triangles were cut this many times, on average over all triangles of
                            // both surfaces
};

namespace detail {

/// The same for triangles. `caller` is named in messages.
distance_bounds distance_between(std::vector<triangle_points> from, std::vector<triangle_points> to,
                                 const hausdorff_options& options, const char* caller);

inline distance_bounds larger_of(const distance_bounds& a, const distance_bounds& b) {
  return {std::max(a.lower, b.lower), std::max(a.upper, b.upper)};
}

/// The triangles of a surface, in units of the mesh.
template<class M>
std::vector<triangle_points> all_triangles(const M& m) {
  const polygon_pieces<M> pieces(m);
  std::vector<triangle_points> triangles(pieces.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) triangles[i][k] = pieces.to_mesh(pieces.triangle(i)[k]);
  return triangles;
}

}  // namespace detail

/// How far a is from b: the largest distance of a point of a from its closest point of b.
/// Needs:  two surfaces of any shape and type; polygons of more than three verts are the triangles of
///         triangulate_polygon.
/// Result: bounds of the distance, in units of the meshes, up to rounding. They hold for all points of a, not for its
///         verts only. 0 if a has no polys, infinite if only b has none.
///         They differ by more than the tolerance if max_cuts is reached, as where a has many points equally far from
///         several parts of b.
/// Cost:   O(n log n) for n triangles, in parallel, if the tree of b is as quick as for bounding_tree.
/// Errors: invalid_mesh if a vert of a poly is not finite; invalid_argument if an option is out of its range.
/// Source: branch and bound, as in Tang, Lee and Kim 2009, "Interactive Hausdorff distance computation for general
///         polygonal models".
template<SurfaceMesh A, SurfaceMesh B>
  requires Embedded<A> && Embedded<B>
distance_bounds one_sided_distance(const A& a, const B& b, const hausdorff_options& options = {}) {
  return detail::distance_between(detail::all_triangles(a), detail::all_triangles(b), options, "one_sided_distance");
}

/// How far two surfaces are apart, the Hausdorff distance: the larger of the one-sided distances of a from b and of b
/// from a.
/// Needs:  as one_sided_distance.
/// Result: bounds, as one_sided_distance. 0 if neither has polys, infinite if one of them has none.
/// Cost:   as one_sided_distance.      Errors: as one_sided_distance.
template<SurfaceMesh A, SurfaceMesh B>
  requires Embedded<A> && Embedded<B>
distance_bounds hausdorff_distance(const A& a, const B& b, const hausdorff_options& options = {}) {
  const auto s = detail::all_triangles(a), t = detail::all_triangles(b);
  return detail::larger_of(detail::distance_between(s, t, options, "hausdorff_distance"),
                           detail::distance_between(t, s, options, "hausdorff_distance"));
}

// What to write instead of calls that cannot compile.
template<class... T> void one_sided_distance(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void hausdorff_distance(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/geometry/detail/hausdorff_distance.ipp>
#endif
