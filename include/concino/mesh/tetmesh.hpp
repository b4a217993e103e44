// tetmesh: a volume of tetrahedra.
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/cell_tables.hpp>
#include <concino/mesh/detail/meshes/native_traits.hpp>
#include <concino/mesh/native_mesh.hpp>

namespace concino {

/// A volume of tetrahedra. Any list of tetrahedra is allowed: several components, verts without polys, more than two
/// polys at a face. The verts of each are in the standard order (law VM7). Descriptors are vert_id, edge_id, face_id,
/// poly_id; verts and polys keep the numbers of the input. All access is through the verbs: verts(m), adj_p2f(m, p),
/// point(m, v) ...
class tetmesh : public detail::native_mesh<tet_tables> {
  using base = detail::native_mesh<tet_tables>;

 public:
  tetmesh() = default;

  /// From flat arrays with arity 4, which are moved, not copied. `order`: the order of the corners of a tet in the
  /// lists.
  /// Cost:   linear in time and memory.
  /// Errors: invalid_mesh that names the poly with a vert out of range or twice, or an array of the wrong size.
  explicit tetmesh(cell_arrays a, tet_order order = tet_order::standard);

  /// From points and lists of 4 verts, as braced lists or containers.
  tetmesh(point_list points, index_lists poly_verts, tet_order order = tet_order::standard);
  template<detail::PointRange Points, detail::IndexListRange Polys>
  tetmesh(const Points& points, const Polys& poly_ranges, tet_order order = tet_order::standard)
      : tetmesh(detail::to_cells(detail::to_points(points), poly_ranges, 4), order) {}
};

template<>
struct mesh_traits<tetmesh> : detail::native_traits<tetmesh, indexed_volume> {
  static constexpr int arity = 4;
};

static_assert(TetMesh<tetmesh> && MutablePoints<tetmesh>);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/meshes/tetmesh.ipp>
#endif
