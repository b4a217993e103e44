// The boundary of a volume as a flat_mesh, for save_options::as_boundary.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/flat_mesh.hpp>
#include <concino/io/options.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The faces of a volume with exactly one poly, wound counter-clockwise seen from outside, and their verts, both in the
/// order of the volume. Verts, edges and the mesh keep their properties; those of faces become properties of polys.
class boundary_flat_mesh final : public flat_mesh {
  flat_mesh& volume_;
  property_set own_properties_;
  std::vector<vec3> own_points_;
  std::vector<vert_id> poly_verts_;
  std::vector<std::size_t> offsets_;
  std::vector<std::uint32_t> numbers_;  // of the verts of the volume in the boundary; ~0u for those inside
  std::vector<std::uint32_t> vert_indices_, poly_indices_;

  void copy_properties();
  void make_polyhedra() override {}
  void make_edges() override;
  void make_corners() override {}

 public:
  /// The volume must not change as long as this object is used.
  explicit boundary_flat_mesh(flat_mesh& volume);

  /// Reports what of the volume is not in its boundary.
  void report_lost(save_report& report) const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/formats/boundary_flat_mesh.ipp>
#endif
