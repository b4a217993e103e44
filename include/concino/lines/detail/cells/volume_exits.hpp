// Where a line along a field leads on from a vert or an edge of a volume: into a cell, along a face, or along an edge.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/lines/detail/cells/incident_cell.hpp>
#include <concino/lines/detail/cells/sliding_velocity.hpp>

#include <span>

namespace concino::detail {

/// From a vert. Of all cells, triangles and edges that lead away from it, the fastest; of several, the one whose
/// velocity comes first in `lies_before`. A triangle leads on if the fields of both its cells push towards it or are
/// parallel to it, an edge if no cell and no triangle leads away from it.
volume_exit steepest_exit(const vec3& from, std::span<const incident_cell> cells);

/// From a place on an edge, or a diagonal, between the vert `from` and the point `to`.
volume_exit steepest_exit(const vec3& from, const vec3& to, const incident_key& edge,
                          std::span<const incident_cell> cells);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/lines/detail/cells/volume_exits.ipp>
#endif
