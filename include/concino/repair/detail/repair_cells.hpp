// Repairs a volume of tets or hexes, as lists of verts.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/repair/detail/repaired_arrays.hpp>
#include <concino/repair/repair_options.hpp>

namespace concino::detail {

repaired_arrays<cell_arrays> repair_cells(cell_arrays a, const repair_options& options, repair_log& log);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/repair/detail/repair_cells.ipp>
#endif
