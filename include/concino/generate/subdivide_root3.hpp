// Root-3 subdivision: smooth surfaces from triangles, with three times as many triangles a step.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/subdivide/root3_step.hpp>

namespace concino {

/// Subdivides a surface of triangles by Kobbelt's scheme: each triangle gets a vert at its centre, and each inner edge
/// is replaced by one between the centres of its two triangles. The verts move, so that repeated subdivision comes near
/// to a smooth surface. Every second step divides each edge of the boundary, and each crease, into three.
/// Needs:  Embedded SurfaceMesh whose polys all have three verts. creases[e], if passed, converts to bool: whether edge
///         e is a crease. Edges with one poly, or with more than two, are creases in any case.
/// Result: a trimesh. Its verts are those of verts(m), then one for each poly, at its centre. In the second, fourth,
///         ... step a triangle on a crease has no vert at its centre; two verts for each crease follow the others. As
///         steps differ, call once with times = 2 instead of twice. Polys on both sides of an edge have both of its
///         triangles as origins. Named properties of verts are interpolated with the weights of the points, others as
///         without smoothing.
/// Cost:   O(size of the result); the points in parallel.
/// Errors: unsupported that names a poly that is no triangle. invalid_argument if times is 0, or if the result would
///         have too many elements.
/// Source: Kobbelt 2000, "Root-3 subdivision".
template<SurfaceMesh M, class C>
  requires Embedded<M> && requirement::is_crease_map<C, M>
trimesh subdivide_root3(const M& m, const C& creases, const subdivide_options& options = {}) {
    return detail::subdivide_repeatedly(
        "subdivide_root3", 3, m, creases, options, [&](const auto& mesh, const auto& sharp, unsigned round) {
          return detail::root3_step("subdivide_root3", mesh, sharp, options, round % 2 == 1);
        });
}
template<SurfaceMesh M>
  requires Embedded<M>
trimesh subdivide_root3(const M& m, const subdivide_options& options = {}) {
  return subdivide_root3(m, detail::no_creases(), options);
}

// What to write instead of calls that cannot compile.
template<class... T> void subdivide_root3(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void subdivide_root3(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
