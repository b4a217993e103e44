// Loop subdivision: smooth surfaces from triangles.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/subdivide/smooth_rules.hpp>
#include <concino/generate/detail/subdivide/subdivided_surface.hpp>

namespace concino {

/// Subdivides a surface of triangles by Loop's scheme: each triangle is split into four, and all verts move, so that
/// repeated subdivision comes near to a smooth surface. The boundary becomes a smooth curve that depends on verts of
/// the boundary alone, and so do creases.
/// Needs:  Embedded SurfaceMesh whose polys all have three verts. creases[e], if passed, converts to bool: whether edge
///         e is a crease. Edges with one poly, or with more than two, are creases in any case.
/// Result: a trimesh, its elements numbered as those of subdivide_1_to_4. A vert at which more than two creases meet
///         stays where it is, and at the end of a single crease the surface is smooth. Named properties of verts are
///         interpolated with the weights of the points, others as without smoothing.
/// Cost:   O(size of the result); the points in parallel.
/// Errors: unsupported that names a poly that is no triangle. invalid_argument if times is 0, or if the result would
///         have too many elements.
/// Source: Loop 1987, "Smooth subdivision surfaces based on triangles"; boundaries and creases by Hoppe et al. 1994,
///         without their special rule for creases with other than three triangles on a side.
template<SurfaceMesh M, class C>
  requires Embedded<M> && requirement::is_crease_map<C, M>
trimesh subdivide_loop(const M& m, const C& creases, const subdivide_options& options = {}) {
    return detail::subdivide_repeatedly(
        "subdivide_loop", 4, m, creases, options, [&](const auto& mesh, const auto& sharp, unsigned) {
          using rule = detail::loop_rule<std::remove_cvref_t<decltype(mesh)>, std::remove_cvref_t<decltype(sharp)>>;
          return detail::subdivide_in_four("subdivide_loop", mesh, sharp, rule{mesh, sharp}, options);
        });
}
template<SurfaceMesh M>
  requires Embedded<M>
trimesh subdivide_loop(const M& m, const subdivide_options& options = {}) {
  return subdivide_loop(m, detail::no_creases(), options);
}

// What to write instead of calls that cannot compile.
template<class... T> void subdivide_loop(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void subdivide_loop(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
