// Catmull-Clark subdivision: smooth surfaces from polygons.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/subdivide/smooth_rules.hpp>
#include <concino/generate/detail/subdivide/subdivided_surface.hpp>

namespace concino {

/// Subdivides a surface of any polygons by the scheme of Catmull and Clark: each polygon is split into a quad at each
/// of its verts, and all verts move, so that repeated subdivision comes near to a smooth surface. Boundaries and
/// creases become smooth curves that depend on their own verts alone.
/// Needs:  Embedded SurfaceMesh. creases[e], if passed, converts to bool: whether edge e is a crease. Edges with one
///         poly, or with more than two, are creases in any case.
/// Result: a quadmesh, its elements numbered as those of subdivide_midpoint. A vert at which more than two creases meet
///         stays where it is, and at the end of a single crease the surface is smooth. Named properties of verts are
///         interpolated with the weights of the points, others as without smoothing.
/// Cost:   O(size of the result), plus the verts of the polys at each vert; the points in parallel.
/// Errors: invalid_argument if times is 0, or if the result would have too many elements.
/// Source: Catmull, Clark 1978, "Recursively generated B-spline surfaces on arbitrary topological meshes"; boundaries
///         and creases by DeRose, Kass, Truong 1998, "Subdivision surfaces in character animation".
template<SurfaceMesh M, class C>
  requires Embedded<M> && requirement::is_crease_map<C, M>
quadmesh subdivide_catmull_clark(const M& m, const C& creases, const subdivide_options& options = {}) {
    return detail::subdivide_repeatedly(
        "subdivide_catmull_clark", 4, m, creases, options, [&](const auto& mesh, const auto& sharp, unsigned) {
          using rule =
              detail::catmull_clark_rule<std::remove_cvref_t<decltype(mesh)>, std::remove_cvref_t<decltype(sharp)>>;
          return detail::subdivide_in_quads("subdivide_catmull_clark", mesh, sharp, rule{mesh, sharp}, options);
        });
}
template<SurfaceMesh M>
  requires Embedded<M>
quadmesh subdivide_catmull_clark(const M& m, const subdivide_options& options = {}) {
  return subdivide_catmull_clark(m, detail::no_creases(), options);
}

// What to write instead of calls that cannot compile.
template<class... T> void subdivide_catmull_clark(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void subdivide_catmull_clark(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
