// Removes parts of cells that have no inside, before cells are cut.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/level_sets/detail/cut/cell_cuts.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// Where two loops have the same places in opposite order, and a region at both of them has the same verts, there is
/// nothing between the loops but faces that two cells share. These loops no longer cut: the region counts as what is
/// around it.
/// Result: the verts of these regions, each once.
std::vector<std::uint32_t> remove_flat_parts(cell_cuts& cuts);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/cut/remove_flat_parts.ipp>
#endif
