// The boundary of a volume as a surface mesh of its own.
#pragma once

#include <concino/convert/convert.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <type_traits>

namespace concino {

struct boundary_surface_options {
  bool properties = true;                             // whether named properties of verts, edges, faces and the mesh
                                                      // are transferred, if m has any
  concino::correspondence* correspondence = nullptr;  // unless null, filled: verts and edges are those of m, and polys
                                                      // are faces of m
};

namespace detail {

/// The kind of mesh of the boundary of a volume.
template<class M>
using boundary_mesh =
    std::conditional_t<arity_v<M> == 4, trimesh, std::conditional_t<arity_v<M> == 8, quadmesh, polygonmesh>>;

/// Transfers the properties of a volume to its boundary; those of faces become properties of polys.
void transfer_to_boundary(const property_set& source, const correspondence& c, property_set& to);

}  // namespace detail

/// The boundary of a volume as a mesh of its own, oriented outward. boundary(m) is a view of it, which has the
/// descriptors of m.
/// Needs:  Embedded VolumeMesh.
/// Result: a trimesh of tets, a quadmesh of hexes, else a polygonmesh, of the faces with exactly one poly. Verts and
///         polys follow the order of verts(m) and faces(m). Properties of verts, edges and the mesh are transferred;
///         those of faces become properties of polys, those of polys are left out. Verts that are not on the boundary
///         are left out.
/// Cost:   O(elements of m) time; for properties of edges, or the correspondence, times the edges at a vert.
/// Errors: none.
template<VolumeMesh M>
  requires Embedded<M>
detail::boundary_mesh<M> boundary_surface(const M& m, const boundary_surface_options& options = {}) {
  const auto view = boundary(m);
  auto converted = convert_with_correspondence<detail::boundary_mesh<M>>(view);
  bool has_properties = false;
  if constexpr (ShowsProperties<M>) has_properties = options.properties && traits<M>::properties(m).size() > 0;
  if (!has_properties && !options.correspondence) return std::move(converted.mesh);
  correspondence from{converted.vert_origins(), converted.edge_origins(), {}, converted.poly_origins()};
  if constexpr (ShowsProperties<M>) {
    if (has_properties)
      detail::transfer_to_boundary(traits<M>::properties(m), from,
                                   traits<detail::boundary_mesh<M>>::properties(converted.mesh));
  }
  if (options.correspondence) *options.correspondence = std::move(from);
  return std::move(converted.mesh);
}

// What to write instead of calls that cannot compile.
template<class... T> void boundary_surface(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void boundary_surface(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/shapes/boundary_surface.ipp>
#endif
