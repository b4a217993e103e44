// Whether cells are convex.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/level_sets/detail/cut/crossed_volume.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Whether a vert of a cell that is no corner of a face lies outside the mean plane of the face, up to rounding.
/// Corners are numbers of verts of the cell.
bool is_vert_outside(std::span<const vec3> verts, std::span<const std::uint32_t> corners, bool outward);

/// Whether no vert of a cell lies outside the mean plane of a face to which it does not belong, up to rounding. The
/// faces may be bent.
bool is_convex_cell(const crossed_volume& v, std::uint32_t cell);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/clip/convex_cells.ipp>
#endif
