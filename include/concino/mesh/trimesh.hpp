// trimesh: a surface of triangles.
#pragma once

#include <concino/mesh/detail/meshes/native_traits.hpp>
#include <concino/mesh/native_mesh.hpp>

namespace concino {

/// A surface of triangles. Any list of triangles is allowed: with boundary, several components, verts without
/// triangles, more than two triangles at an edge. Descriptors are vert_id, edge_id, poly_id; verts and polys keep the
/// numbers of the input. All access is through the verbs: verts(m), adj_p2v(m, p), point(m, v) ...
class trimesh : public detail::native_mesh<surface_tables<3>> {
  using base = detail::native_mesh<surface_tables<3>>;

 public:
  trimesh() = default;

  /// From flat arrays with arity 3, which are moved, not copied.
  /// Cost:   linear in time and memory.
  /// Errors: invalid_mesh that names the poly with a vert out of range or twice, or an array of the wrong size.
  explicit trimesh(surface_arrays a);

  /// From points and lists of 3 verts, as braced lists or containers.
  trimesh(point_list points, index_lists poly_verts);
  template<detail::PointRange Points, detail::IndexListRange Polys>
  trimesh(const Points& points, const Polys& poly_ranges)
      : trimesh(detail::to_surface(detail::to_points(points), poly_ranges, 3, "trimesh")) {}
};

template<>
struct mesh_traits<trimesh> : detail::native_traits<trimesh, indexed_surface> {
  static constexpr int arity = 3;
};

static_assert(TriMesh<trimesh> && MutablePoints<trimesh>);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/meshes/trimesh.ipp>
#endif
