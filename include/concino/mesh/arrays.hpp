// Flat arrays that describe a whole mesh: file readers return them, meshes are built from them and can be converted
// back to them.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/vec3.hpp>

#include <concepts>
#include <cstdint>
#include <vector>

namespace concino {

/// A surface. The verts of all polys are stored one after another: poly p has verts[offsets[p]] ..
/// verts[offsets[p+1]-1]. offsets has one entry more than there are polys and begins with 0. If every poly has `arity`
/// verts (> 0), offsets stays empty.
struct surface_arrays {
  std::vector<vec3> points;
  std::vector<std::uint32_t> offsets;
  std::vector<vert_id> verts;
  std::uint32_t arity = 0;

  std::size_t num_polys() const { return arity ? verts.size() / arity : offsets.empty() ? 0 : offsets.size() - 1; }
};

/// A volume of tets or of hexes: 4 verts per tet or 8 per hex, in the standard order.
struct cell_arrays {
  std::vector<vec3> points;
  std::vector<vert_id> verts;
  std::uint32_t arity = 4;  // 4 or 8

  std::size_t num_polys() const { return verts.size() / arity; }
};

/// A volume of general polyhedra: faces are lists of verts, polys are lists of faces. outward[i] says whether the verts
/// of face poly_faces[i], in the order listed, run counter-clockwise seen from outside the poly.
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

/// The arrays from which an M is constructed.
template<class M>
inline constexpr bool from_surface = std::constructible_from<M, surface_arrays&&>;
template<class M>
inline constexpr bool from_cells = std::constructible_from<M, cell_arrays&&>;
template<class M>
inline constexpr bool from_polyhedra = std::constructible_from<M, polyhedra_arrays&&>;

}  // namespace detail

}  // namespace concino
