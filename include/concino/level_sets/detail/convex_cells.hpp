// Whether cells are convex.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/level_sets/detail/crossed_volume.hpp>

namespace concino::detail {

/// Whether no vert of a cell lies outside the mean plane of a face to which it does not belong, up to rounding. The faces may be bent.
bool is_convex_cell(const crossed_volume& v, std::uint32_t cell);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/convex_cells.ipp>
#endif
