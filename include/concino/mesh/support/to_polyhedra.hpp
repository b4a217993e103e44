// Conversion of tets and hexes to general polyhedra.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/arrays.hpp>

#include <concepts>

namespace concino {

/// The same volume as general polyhedra; polys keep their order.
/// Needs:  cells in the standard order; their arrays are moved from.
/// Result: polyhedra; faces are numbered in the order of their first occurrence.   Cost: O(n), but for sorting faces of
///         equal smallest vert.
/// Errors: none but std::bad_alloc.
template<std::same_as<cell_arrays> Cells>  // a template only so that programs without volumes need not compile it
polyhedra_arrays to_polyhedra(Cells&& cells);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/cells/to_polyhedra.ipp>
#endif
