// Subdivision of triangles into four, without moving verts.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/subdivide/subdivided_surface.hpp>

namespace concino {

/// Splits each triangle into four: its edges are halved, and three new edges join their midpoints.
/// Needs:  Embedded SurfaceMesh whose polys all have three verts.
/// Result: a trimesh. Its verts are those of verts(m), then one for each edge of edges(m), at its midpoint. Poly i of
///         polys(m) becomes polys 4 i to 4 i + 3: one at each of its verts, and the middle one. Named properties are
///         transferred by their rules. The surface stays the same.
/// Cost:   O(size of the result); the points in parallel.
/// Errors: unsupported that names a poly that is no triangle. invalid_argument if times is 0, or if the result would
///         have too many elements.
template<SurfaceMesh M>
  requires Embedded<M>
trimesh subdivide_1_to_4(const M& m, const subdivide_options& options = {}) {
    return detail::subdivide_repeatedly("subdivide_1_to_4", 4, m, detail::no_creases(), options,
                                        [&](const auto& mesh, const auto& creases, unsigned) {
                                          using mesh_type = std::remove_cvref_t<decltype(mesh)>;
                                          return detail::subdivide_in_four("subdivide_1_to_4", mesh, creases,
                                                                           detail::mean_rule<mesh_type>{mesh}, options);
                                        });
}

// What to write instead of calls that cannot compile.
template<class... T> void subdivide_1_to_4(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void subdivide_1_to_4(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
