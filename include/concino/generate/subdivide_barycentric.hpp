// Barycentric subdivision: triangles from any surface, tets from any volume.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/subdivide/subdivided_surface.hpp>
#include <concino/mesh/tetmesh.hpp>

namespace concino {

namespace detail {

template<SurfaceMesh M>
subdivided<trimesh> subdivide_at_centres(const M& m, const subdivide_options& o) {
  using new_verts = refined_verts<M, refined_kinds{.edges = true, .polys = true}>;
  const std::size_t corners = num_poly_corners(m);
  check_subdivided_counts<trimesh>("subdivide_barycentric", new_verts::expected_size(m),
                                   2.0 * static_cast<double>(corners));
  const new_verts refined(m);
  surface_arrays a{{}, {}, {}, 3};
  a.verts.reserve(6 * corners);
  for (const poly_t<M> p : polys(m))
    for (const auto& [e, from, to] : oriented_edges(m, p))
      a.verts.insert(a.verts.end(), {refined[from], refined[e], refined[p], refined[e], refined[to], refined[p]});
  const mean_rule<M> rule{m};
  a.points = refined_points(refined, rule);
  return with_origins(trimesh(std::move(a)), refined, rule, o, [&] { return polys_of_corners(m, 2); });
}

template<VolumeMesh M>
subdivided<tetmesh> subdivide_at_centres(const M& m, const subdivide_options& o) {
  std::size_t corners = 0;  // of the faces of all polys
  for (const poly_t<M> p : polys(m))
    for (const face_t<M> f : adj_p2f(m, p)) corners += num_elements(adj_f2v(m, f));
  using new_verts = refined_verts<M, refined_kinds{.edges = true, .faces = true, .polys = true}>;
  check_subdivided_counts<tetmesh>("subdivide_barycentric", new_verts::expected_size(m),
                                   2.0 * static_cast<double>(corners));
  const new_verts refined(m);
  cell_arrays a{{}, {}, 4};
  a.verts.reserve(8 * corners);
  std::vector<std::uint32_t> from;
  const bool wanted = wants_origins(m, o);
  for (const poly_t<M> p : polys(m)) {
    for (const face_t<M> f : adj_p2f(m, p)) {
      const bool outward = face_is_outward(m, p, f);
      for (const auto& [e, begin, end] : oriented_edges(m, f)) {
        const vert_id first = refined[outward ? begin : end], last = refined[outward ? end : begin];
        a.verts.insert(a.verts.end(),
                       {refined[e], first, refined[f], refined[p], last, refined[e], refined[f], refined[p]});
      }
    }
    if (wanted) from.resize(a.verts.size() / 4, static_cast<std::uint32_t>(index_of(m, p)));
  }
  const mean_rule<M> rule{m};
  a.points = refined_points(refined, rule);
  return with_origins(tetmesh(std::move(a)), refined, rule, o, [&] { return element_origins(std::move(from)); });
}

}  // namespace detail

/// Splits each polygon into triangles, or each polyhedron into tets: one for each vert, edge at it, (in volumes) face
/// at this, and poly. The new verts are at the means of the verts of an element.
/// Needs:  EmbeddedMesh.
/// Result: a trimesh or tetmesh. Its verts are those of verts(m), then one for each edge, each face (in volumes) and
///         each poly, in the order of m; its polys follow those of m. They are oriented as m. Areas and volumes do not
///         change where polygons and faces are planar. Named properties are transferred by their rules. In polys that
///         the means of their verts do not see as a whole, some triangles or tets are inverted.
/// Cost:   O(size of the result); the points in parallel.
/// Errors: invalid_argument if times is 0, or if the result would have too many elements.
/// Source: Munkres 1984, "Elements of algebraic topology", section 15.
template<EmbeddedMesh M>
auto subdivide_barycentric(const M& m, const subdivide_options& options = {}) {
  return detail::subdivide_repeatedly(
      "subdivide_barycentric", dimension_v<M> == 2 ? 6 : 24, m, detail::no_creases(), options,
      [&](const auto& mesh, const auto&, unsigned) { return detail::subdivide_at_centres(mesh, options); });
}

// What to write instead of calls that cannot compile.
template<class... T> void subdivide_barycentric(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void subdivide_barycentric(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
