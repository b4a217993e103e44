// Tets from any volume, which fit together at all faces.
#pragma once

#include <concino/convert/convert.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/common/construct_from_arrays.hpp>
#include <concino/generate/detail/common/finite.hpp>
#include <concino/generate/detail/subdivide/subdivision.hpp>
#include <concino/generate/detail/volumes/cell_tets.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/mesh/tetmesh.hpp>

namespace concino {

struct to_tets_options {
  bool properties = true;                             // whether named properties are transferred, if m has any
  concino::correspondence* correspondence = nullptr;  // unless null, filled with the elements of m of which those of
                                                      // the result were made
  std::vector<poly_id>* inverted = nullptr;           // unless null, filled with the polys of the result without
                                                      // positive volume
  std::vector<std::size_t>* inverted_cells = nullptr; // unless null, filled with the indices of the polys of m of which
                                                      // those were made
};

namespace detail {

/// Cuts all faces of m into triangles.
template<class M>
face_triangles triangles_of_faces(const M& m, const std::vector<std::uint32_t>& vert_number,
                                  const std::vector<vec3>& points) {
  face_triangles triangles(face_index_bound(m));
  std::vector<vert_id> loop;
  for (const face_t<M> f : faces(m)) {
    loop.clear();
    for (const vert_t<M> v : adj_f2v(m, f)) loop.push_back(vert_id{vert_number[index_of(m, v)]});
    if (!loop.empty()) triangles.add(index_of(m, f), loop, points);
  }
  return triangles;
}

}  // namespace detail

/// Cuts each polyhedron into tets. Every face is cut in the same way for both of its polys, so that the tets fit
/// together.
/// Needs:  Embedded VolumeMesh.
/// Result: a tetmesh. Its verts are those of verts(m), then a new one for each poly that needs it; its polys follow
///         those of m. A face is cut at its vert that is first in verts(m), if all triangles there have its
///         orientation; otherwise as to_triangles does. Tets, pyramids, prisms and hexes become 1, 2, 3 and 5 or 6
///         tets, without new verts. Other polys, and those of which a tet would not have positive volume, are cut from
///         the mean of their verts, which is a new vert. This works if the mean sees the whole boundary of the poly.
///         Polys where neither way works are cut all the same, the standard shapes without new verts, and are listed:
///         options.inverted, options.inverted_cells. Signed volumes do not change where faces are planar. Named
///         properties are transferred by their rules; tets count by their volumes.
/// Cost:   O(size of the result).
/// Errors: invalid_mesh that names a vert whose point is not finite. invalid_argument if the result would have too many
///         elements.
/// Source: Dompierre, Labbe, Vallet, Camarero 1999, "How to subdivide pyramids, prisms and hexahedra into tetrahedra".
template<VolumeMesh M>
  requires Embedded<M>
tetmesh to_tets(const M& m, const to_tets_options& options = {}) {
  detail::check_points_finite("to_tets", m, "validate() lists all such verts");
  const std::vector<std::uint32_t> vert_number = core::numbered(m, verts(m), vert_index_bound(m));
  detail::cell_cutter cutter(core::copy_points(m));
  const detail::face_triangles triangles = detail::triangles_of_faces(m, vert_number, cutter.tets.points);
  cutter.tets.verts.reserve(4 * 6 * num_polys(m));
  element_origins of_verts = detail::copied_verts(m);
  std::vector<origin> of_mean;
  for (const poly_t<M> p : polys(m)) {
    cutter.begin_cell();
    for (const face_t<M> f : adj_p2f(m, p)) cutter.add_face(triangles[index_of(m, f)], face_is_outward(m, p, f));
    if (!cutter.cut(index_of(m, p), num_elements(adj_p2v(m, p)), [&] { return vert_mean(m, p); })) continue;
    of_mean.clear();
    for (const vert_t<M> v : adj_p2v(m, p)) of_mean.push_back({static_cast<std::uint32_t>(index_of(m, v))});
    of_verts.add(of_mean);
  }
  detail::check_element_counts<tetmesh>("to_tets", "the mesh", static_cast<double>(cutter.tets.points.size()),
                                        static_cast<double>(cutter.tets.verts.size()) / 24);
  detail::subdivided<tetmesh> result{tetmesh(std::move(cutter.tets))};
  const subdivide_options shared{1, options.properties, options.correspondence};
  if (detail::wants_origins(m, shared)) {
    result.from.polys = cutter.poly_origins();
    detail::set_origins(m, std::move(of_verts), {}, shared, result);
  }
  if (options.inverted) *options.inverted = std::move(cutter.inverted);
  if (options.inverted_cells) *options.inverted_cells = std::move(cutter.inverted_cells);
  if (options.correspondence) *options.correspondence = std::move(result.from);
  return std::move(result.mesh);
}

// What to write instead of calls that cannot compile.
template<class... T> void to_tets(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void to_tets(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
