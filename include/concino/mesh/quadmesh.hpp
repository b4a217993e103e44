// quadmesh: a surface of quadrilaterals.
#pragma once

#include <concino/mesh/detail/meshes/native_traits.hpp>
#include <concino/mesh/native_mesh.hpp>

namespace concino {

/// A surface of quadrilaterals. Any list of quadrilaterals is allowed: with boundary, several components, verts without
/// quadrilaterals, more than two quadrilaterals at an edge. Descriptors are vert_id, edge_id, poly_id; verts and polys
/// keep the numbers of the input. All access is through the verbs: verts(m), adj_p2v(m, p), point(m, v) ...
class quadmesh : public detail::native_mesh<surface_tables<4>> {
  using base = detail::native_mesh<surface_tables<4>>;

 public:
  quadmesh() = default;

  /// From flat arrays with arity 4, which are moved, not copied.
  /// Cost:   linear in time and memory.
  /// Errors: invalid_mesh that names the poly with a vert out of range or twice, or an array of the wrong size.
  explicit quadmesh(surface_arrays a);

  /// From points and lists of 4 verts, as braced lists or containers.
  quadmesh(point_list points, index_lists poly_verts);
  template<detail::PointRange Points, detail::IndexListRange Polys>
  quadmesh(const Points& points, const Polys& poly_ranges)
      : quadmesh(detail::to_surface(detail::to_points(points), poly_ranges, 4, "quadmesh")) {}
};

template<>
struct mesh_traits<quadmesh> : detail::native_traits<quadmesh, indexed_surface> {
  static constexpr int arity = 4;
};

static_assert(QuadMesh<quadmesh> && MutablePoints<quadmesh>);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/meshes/quadmesh.ipp>
#endif
