// The tets that a back end returned: the parts into which the surface and the facets divide them, and whether they keep
// what was promised.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/generate/detail/volumes/closed_surface.hpp>
#include <concino/generate/tetrahedralize_options.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

class tet_complex {
 public:
  static constexpr std::uint32_t none = ~0u;

  /// Takes the points and the tets of the output, which get a positive volume by the order of their corners.
  /// Errors: unsupported that names the back end if points were to be kept and a point of the surface is missing, a tet
  ///         has no volume, more than two tets have a face, or a number is out of range.
  tet_complex(const closed_surface& surface, tetrahedralize_output output, const char* back_end,
              bool keeps_points = true);

  /// How often the surface winds around each tet. Outside it is 0, and it changes by 1 at each facet of the surface.
  /// Errors: unsupported if the boundary of the tets is not part of the surface, or tets are on both sides of it where
  ///         they cannot be.
  std::vector<int> winding_numbers() const;
  /// Errors: unsupported unless every triangle of the surface is covered by its facets, and, if it was to be kept, by
  ///         one with the same corners.
  void check_boundary(bool keep) const;
  /// The tets of the part, bounded by facets, that contains a point; empty if no tet contains it.
  std::vector<poly_id> part_at(const vec3& q) const;

  const tetmesh& mesh() const { return mesh_; }
  tetmesh& mesh() { return mesh_; }
  /// The triangle of the input in which a face lies, or none.
  std::uint32_t triangle(face_id f) const { return triangle_of_face_[f.raw()]; }

  [[noreturn, gnu::cold]] void throw_broken(const char* what) const;

 private:
  const closed_surface& surface_;
  const char* back_end_;
  tetmesh mesh_;
  std::vector<std::uint32_t> triangle_of_face_;

  void take_tets(tetrahedralize_output& output);
  void find_facets(const tetrahedralize_output& output);
  bool is_of_surface(face_id f) const { return triangle(f) < surface_.input.surface_triangles; }
  int change_inwards(poly_id p, face_id f) const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/volumes/tet_complex.ipp>
#endif
