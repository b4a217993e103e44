// polyhedralmesh: a volume of general polyhedra.
#pragma once

#include <concino/mesh/detail/meshes/native_traits.hpp>
#include <concino/mesh/native_mesh.hpp>
#include <concino/mesh/polyhedra_tables.hpp>

namespace concino {

/// A volume of polyhedra with any number of faces of any size. Any lists are allowed: faces without polys, polys that
/// are not closed, more than two polys at a face. They are rejected only if faces of more than 16 verts have very many
/// polys. Descriptors are vert_id, edge_id, face_id, poly_id; verts, faces and polys keep the numbers of the input. All
/// access is through the verbs: verts(m), adj_p2f(m, p), point(m, v) ...
class polyhedralmesh : public detail::native_mesh<polyhedra_tables> {
  using base = detail::native_mesh<polyhedra_tables>;

 public:
  polyhedralmesh();

  /// From flat arrays, which are moved, not copied.
  /// Cost:   linear in time and memory.
  /// Errors: invalid_mesh that names a face with fewer than 3 verts, or with a vert out of range or twice. The same for
  ///         a poly with no face, or with a face out of range or twice, and for arrays that do not fit each other.
  ///         unsupported if faces of more than 16 verts belong to so many polys (always more than 16) that the
  ///         adjacencies would be far longer than the arrays.
  explicit polyhedralmesh(polyhedra_arrays a);

  /// From points, lists of verts and lists of {face, outward?}, as braced lists or containers.
  polyhedralmesh(point_list points, index_lists face_verts, face_lists poly_faces);
  template<detail::PointRange Points, detail::IndexListRange Faces, class Polys>
  polyhedralmesh(const Points& points, const Faces& face_ranges, const Polys& poly_ranges)
      : polyhedralmesh(detail::polyhedra_arrays_from(detail::to_points(points), face_ranges, poly_ranges)) {}
};

template<>
struct mesh_traits<polyhedralmesh> : detail::native_traits<polyhedralmesh, indexed_volume> {};

static_assert(VolumeMesh<polyhedralmesh> && MutablePoints<polyhedralmesh> && !TetMesh<polyhedralmesh>);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/meshes/polyhedralmesh.ipp>
#endif
