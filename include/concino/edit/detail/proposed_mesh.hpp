// A poly of a proposed edit as a mesh of its own, for what is asked of meshes.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/edit/proposed_edit.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

#include <cstddef>
#include <array>
#include <vector>

namespace concino::detail {

/// New poly k as a mesh of one poly.
/// Needs:  mesh_dimension(e) is 2, or 3.
polygonmesh new_polygon(const proposed_edit& e, std::size_t k);
polyhedralmesh new_polyhedron(const proposed_edit& e, std::size_t k);

/// The dimension of the mesh that is edited.
inline unsigned mesh_dimension(const proposed_edit& e) {
  return e.corners_per_poly == 0 ? e.dimension : e.corners_per_poly - 1;
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/edit/detail/proposed_mesh.ipp>
#endif
