// Flat arrays that say everything about a mesh: what files are read into, what meshes are built from and can be given back as.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/vec3.hpp>

#include <concepts>
#include <cstdint>
#include <vector>

namespace concino {

/// Surfaces: the verts of all polys one after another. Poly p's are verts[offsets[p]] .. verts[offsets[p+1]-1]; offsets has one entry
/// more than there are polys and begins with 0. Where every poly has `arity` verts (> 0), offsets stays empty.
struct surface_arrays {
  std::vector<vec3> points;
  std::vector<std::uint32_t> offsets;
  std::vector<vert_id> verts;
  std::uint32_t arity = 0;

  std::size_t num_polys() const { return arity ? verts.size() / arity : offsets.empty() ? 0 : offsets.size() - 1; }
};

/// Volumes of one shape: 4 verts a tet or 8 a hex, in the standard order.
struct cell_arrays {
  std::vector<vec3> points;
  std::vector<vert_id> verts;
  std::uint32_t arity = 4;  // 4 or 8

  std::size_t num_polys() const { return verts.size() / arity; }
};

/// Volumes of any polyhedra: faces as lists of verts, polys as lists of faces; outward[i] says whether face poly_faces[i], walked as
/// listed, runs counter-clockwise seen from outside the poly.
struct polyhedra_arrays {
  std::vector<vec3> points;
  std::vector<std::uint32_t> face_offsets;
  std::vector<vert_id> face_verts;
  std::vector<std::uint32_t> poly_offsets;
  std::vector<face_id> poly_faces;
  std::vector<std::uint8_t> outward;  // 0 or 1, parallel to poly_faces

  std::size_t num_faces() const { return face_offsets.empty() ? 0 : face_offsets.size() - 1; }
  std::size_t num_polys() const { return poly_offsets.empty() ? 0 : poly_offsets.size() - 1; }
};

namespace detail {

/// What M is made from.
template<class M>
inline constexpr bool from_surface = std::constructible_from<M, surface_arrays&&>;
template<class M>
inline constexpr bool from_cells = std::constructible_from<M, cell_arrays&&>;
template<class M>
inline constexpr bool from_polyhedra = std::constructible_from<M, polyhedra_arrays&&>;

}  // namespace detail

}  // namespace concino
