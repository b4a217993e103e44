// Quads from triangles: as many pairs of triangles as possible are joined.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/generate/detail/common/finite.hpp>
#include <concino/generate/detail/quads/triangle_pairs.hpp>
#include <concino/generate/detail/subdivide/subdivision.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <numbers>

namespace concino {

struct quads_from_triangles_options {
  double max_angle_deg = 180;  // in degrees, above 90 and at most 180: each corner of a quad is smaller
  bool properties = true;      // whether named properties are transferred, if m has any
  concino::correspondence* correspondence = nullptr;  // unless null, filled with the elements of m of which those of
                                                      // the result were made
  std::vector<poly_id>* triangles = nullptr;          // unless null, filled with the polys of the result that are still
                                                      // triangles
};

namespace detail {

/// Errors: unsupported that names a poly that is no triangle. invalid_mesh that names a vert whose point is not finite.
template<class M>
triangle_list triangles_of(const char* caller, const M& m) {
  triangle_list list;
  check_points_finite(caller, m, "validate() lists all such verts");
  const std::vector<std::uint32_t> number = core::numbered(m, verts(m), vert_index_bound(m));
  list.points = core::copy_points(m);
  list.num_edges = edge_index_bound(m);
  list.polys.reserve(num_polys(m));
  list.verts.reserve(3 * num_polys(m));
  list.edges.reserve(3 * num_polys(m));
  for (const poly_t<M> p : polys(m)) {
    const triangle_elements<M> t(caller, m, p);
    list.polys.push_back(static_cast<std::uint32_t>(index_of(m, p)));
    for (const std::size_t k : {0u, 1u, 2u}) {
      list.verts.push_back(vert_id{number[index_of(m, t.verts[k])]});
      list.edges.push_back(static_cast<std::uint32_t>(index_of(m, t.edges[k])));
    }
  }
  return list;
}

}  // namespace detail

/// Joins pairs of triangles to quads, the best pairs first, then along paths of pairs until no more quads are possible.
/// Needs:  Embedded SurfaceMesh whose polys all have three verts.
/// Result: a polygonmesh with the verts of verts(m). A quad is at the place of its first triangle in polys(m), and has
///         its orientation. Pairs are compared by the corner that differs most from 90 degrees, with the two triangles
///         unfolded into a plane, where all quads are convex. Not joined are triangles without area, pairs that share
///         two edges, and pairs at edges with other than two polys or where the orientations differ. What is left are
///         triangles, the fewest possible. On closed manifold surfaces there are none, unless pairs were excluded.
///         Named properties are transferred by their rules; the two triangles count by their areas.
/// Cost:   O(n log n) for n triangles in practice; at worst O(n^2).
/// Errors: unsupported that names a poly that is no triangle. invalid_mesh that names a vert whose point is not finite.
///         invalid_argument if max_angle_deg is out of its range.
/// Source: Edmonds 1965, "Paths, trees, and flowers"; that closed surfaces have perfect matchings: Petersen 1891, "Die
///         Theorie der regulaeren graphs".
template<SurfaceMesh M>
  requires Embedded<M>
polygonmesh quads_from_triangles(const M& m, const quads_from_triangles_options& options = {}) {
  if (!(options.max_angle_deg > 90 && options.max_angle_deg <= 180))
    core::throw_joined<invalid_argument>({"quads_from_triangles: max_angle_deg is ",
                                          core::number_text(options.max_angle_deg),
                                          "; it must be above 90 and at most 180"});
  detail::joined_triangles joined = detail::join_triangles(detail::triangles_of("quads_from_triangles", m),
                                                           options.max_angle_deg * (std::numbers::pi / 180));
  detail::subdivided<polygonmesh> result{polygonmesh(std::move(joined.polygons))};
  const subdivide_options shared{1, options.properties, options.correspondence};
  if (detail::wants_origins(m, shared)) {
    result.from.polys = std::move(joined.from);
    detail::set_origins(m, detail::copied_verts(m), {}, shared, result);
  }
  if (options.triangles) *options.triangles = std::move(joined.triangles);
  if (options.correspondence) *options.correspondence = std::move(result.from);
  return std::move(result.mesh);
}

// What to write instead of calls that cannot compile.
template<class... T> void quads_from_triangles(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void quads_from_triangles(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
