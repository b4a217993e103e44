// polygonmesh: a surface of polygons of any size.
#pragma once

#include <concino/mesh/detail/meshes/native_traits.hpp>
#include <concino/mesh/native_mesh.hpp>

namespace concino {

/// A surface of general polygons. Any list of polygons is allowed: with boundary, several components, verts without
/// polygons, more than two polygons at an edge, concave or not planar polygons. Descriptors are vert_id, edge_id,
/// poly_id; verts and polys keep the numbers of the input. All access is through the verbs: verts(m), adj_p2v(m, p),
/// point(m, v) ...
class polygonmesh : public detail::native_mesh<surface_tables<0>> {
  using base = detail::native_mesh<surface_tables<0>>;

 public:
  polygonmesh();

  /// From flat arrays, which are moved, not copied.
  /// Cost:   linear in time and memory.
  /// Errors: invalid_mesh that names the poly with fewer than 3 verts, or with a vert out of range or twice, or says
  ///         what is wrong with the offsets.
  explicit polygonmesh(surface_arrays a);

  /// From points and lists of verts, as braced lists or containers.
  polygonmesh(point_list points, index_lists poly_verts);
  template<detail::PointRange Points, detail::IndexListRange Polys>
  polygonmesh(const Points& points, const Polys& poly_ranges)
      : polygonmesh(detail::to_surface(detail::to_points(points), poly_ranges, 0, "polygonmesh")) {}
};

template<>
struct mesh_traits<polygonmesh> : detail::native_traits<polygonmesh, indexed_surface> {};

static_assert(SurfaceMesh<polygonmesh> && MutablePoints<polygonmesh> && !TriMesh<polygonmesh>);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/meshes/polygonmesh.ipp>
#endif
