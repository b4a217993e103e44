// The measures of the parts above a level set, without making a mesh of them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/level_sets/detail/cut/cell_parts.hpp>
#include <concino/level_sets/detail/cut/poly_parts.hpp>

namespace concino::detail {

/// The areas of the parts above, added.
double area_above(const poly_parts& parts, const crossed_surface& s, double level);

/// The volumes of the parts above, added.
double volume_above(const cell_parts& parts, const crossed_volume& v);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/clip/measure_parts.ipp>
#endif
