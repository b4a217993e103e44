// hexmesh: a volume of hexahedra.
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/cell_tables.hpp>
#include <concino/mesh/detail/meshes/native_traits.hpp>
#include <concino/mesh/native_mesh.hpp>

namespace concino {

/// A volume of hexahedra. Any list of hexahedra is allowed: several components, verts without polys, more than two
/// polys at a face. The verts of each are in the standard order (law VM7). Descriptors are vert_id, edge_id, face_id,
/// poly_id; verts and polys keep the numbers of the input. All access is through the verbs: verts(m), adj_p2f(m, p),
/// point(m, v) ...
class hexmesh : public detail::native_mesh<hex_tables> {
  using base = detail::native_mesh<hex_tables>;

 public:
  hexmesh() = default;

  /// From flat arrays with arity 8, which are moved, not copied. `order`: the order of the corners of a hex in the
  /// lists.
  /// Cost:   linear in time and memory.
  /// Errors: invalid_mesh that names the poly with a vert out of range or twice, or an array of the wrong size.
  explicit hexmesh(cell_arrays a, hex_order order = hex_order::standard);

  /// From points and lists of 8 verts, as braced lists or containers.
  hexmesh(point_list points, index_lists poly_verts, hex_order order = hex_order::standard);
  template<detail::PointRange Points, detail::IndexListRange Polys>
  hexmesh(const Points& points, const Polys& poly_ranges, hex_order order = hex_order::standard)
      : hexmesh(detail::to_cells(detail::to_points(points), poly_ranges, 8), order) {}
};

template<>
struct mesh_traits<hexmesh> : detail::native_traits<hexmesh, indexed_volume> {
  static constexpr int arity = 8;
};

static_assert(HexMesh<hexmesh> && MutablePoints<hexmesh>);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/meshes/hexmesh.ipp>
#endif
