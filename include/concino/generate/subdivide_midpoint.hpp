// Midpoint subdivision: quads from any surface, hexes from volumes.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/common/inverted_polys.hpp>
#include <concino/generate/detail/subdivide/corner_hexes.hpp>
#include <concino/generate/detail/subdivide/subdivided_surface.hpp>

namespace concino {

struct midpoint_options {
  unsigned times = 1;                                 // how often the mesh is subdivided, 1 or more
  bool properties = true;                             // whether named properties are transferred, if m has any
  concino::correspondence* correspondence = nullptr;  // unless null, filled with the elements of m of which those of
                                                      // the result were made
  std::vector<poly_id>* inverted = nullptr;           // unless null, filled with the polys of the result whose scaled
                                                      // Jacobian is not above 0
};

/// Splits each polygon into quads, or each polyhedron into hexes, one at each of its verts. The other corners are the
/// midpoints of the edges at the vert, the means of the verts of the faces at it, and the mean of the verts of the
/// poly.
/// Needs:  EmbeddedMesh. In volumes, three edges of each poly meet at each of its verts.
/// Result: a quadmesh or hexmesh. Its verts are those of verts(m), then one for each edge, each face (in volumes) and
///         each poly, in the order of m; its polys follow those of m, and the verts of each in the order of adj_p2v.
///         Hexes are oriented as m. Areas and volumes do not change where polygons and faces are planar. Named
///         properties are transferred by their rules. Quads and hexes in polys that are not convex may be inverted;
///         options.inverted lists them.
/// Cost:   O(size of the result); the points in parallel.
/// Errors: unsupported that names a poly and its vert with other than three edges. invalid_mesh that names a poly whose
///         faces are not closed around a vert. invalid_argument if times is 0, or if the result would have too many
///         elements.
/// Source: paper section 2.2, "midpoint subdivision"; Li, McKeag, Armstrong 1995, "Hexahedral meshing using midpoint
///         subdivision and integer programming".
template<SurfaceMesh M>
  requires Embedded<M>
quadmesh subdivide_midpoint(const M& m, const midpoint_options& options = {}) {
  const subdivide_options shared{options.times, options.properties, options.correspondence};
  quadmesh result = detail::subdivide_repeatedly(
      "subdivide_midpoint", 4, m, detail::no_creases(), shared, [&](const auto& mesh, const auto& creases, unsigned) {
        return detail::subdivide_in_quads("subdivide_midpoint", mesh, creases,
                                          detail::mean_rule<std::remove_cvref_t<decltype(mesh)>>{mesh}, shared);
      });
  if (options.inverted) *options.inverted = detail::inverted_polys(result);
  return result;
}
template<VolumeMesh M>
  requires Embedded<M>
hexmesh subdivide_midpoint(const M& m, const midpoint_options& options = {}) {
  const subdivide_options shared{options.times, options.properties, options.correspondence};
  hexmesh result = detail::subdivide_repeatedly("subdivide_midpoint", 8, m, detail::no_creases(), shared,
                                                [&](const auto& mesh, const auto&, unsigned) {
                                                  return detail::subdivide_in_hexes("subdivide_midpoint", mesh, shared);
                                                });
  if (options.inverted) *options.inverted = detail::inverted_polys(result);
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void subdivide_midpoint(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void subdivide_midpoint(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
