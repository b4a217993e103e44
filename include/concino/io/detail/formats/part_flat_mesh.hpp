// A part of a mesh as a flat_mesh: some of its polys, and their verts.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/flat_mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Some polys of a mesh, in increasing order, and their verts and faces, in the order of the mesh. Verts, faces, polys
/// and the mesh keep their properties; edges and corners are left out.
class part_flat_mesh final : public flat_mesh {
  flat_mesh& whole_;
  std::span<const std::uint32_t> polys_;
  std::vector<std::uint32_t> verts_, vert_indices_, poly_indices_, face_indices_;  // verts_: their numbers in the whole
  std::vector<vec3> own_points_;
  std::vector<vert_id> poly_verts_, face_verts_;
  std::vector<face_id> poly_faces_;
  std::vector<std::size_t> offsets_, face_offsets_, poly_face_offsets_;
  std::vector<std::uint8_t> outward_;

  vert_id number_of(vert_id v) const;
  void collect_verts(std::span<const std::uint32_t> more);
  void make_polyhedra() override;
  void make_edges() override {}
  void make_corners() override {}

 public:
  /// The part has the verts of the polys and those in `more`. The properties are those of the whole mesh, by its
  /// indices, and others. The whole must not change as long as this object is used, and it has called polyhedra(), if
  /// it is a volume of polys with different numbers of verts.
  part_flat_mesh(flat_mesh& whole, std::span<const std::uint32_t> polys, std::span<const std::uint32_t> more,
                 const property_set& all_properties);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/formats/part_flat_mesh.ipp>
#endif
