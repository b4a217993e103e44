// Contours that bound regions already, as those of most slices do. No back end is asked for them, which may take long
// if there are many points.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/print/polygon_clipper.hpp>

#include <optional>

namespace concino::detail {

/// The regions of contours, with all their points, if contours do not meet, and wind around nothing with another number
/// than 0 or 1.
/// Needs:  paths of three points or more, without repetitions.      Cost: O(n log n) for n points.      Errors: none.
std::optional<lattice_regions> disjoint_regions(const lattice_paths& paths);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/print/detail/regions/disjoint_regions.ipp>
#endif
