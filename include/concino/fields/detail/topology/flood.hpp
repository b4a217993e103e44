// Raises the values around minima of a graph until only chosen ones are left.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/fields/detail/topology/sorted_graph.hpp>

#include <vector>

namespace concino::detail {

/// The values by rank, changed so that the minima whose persistence is less than the threshold are none any more; or
/// the maxima, by lowering the values.
std::vector<double> flooded_values(const ranked_graph& g, double threshold, bool of_maxima);

/// Errors: invalid_argument unless one of the two thresholds is above 0, the other is 0, and neither is NaN.
void check_thresholds(double minima_below, double maxima_below);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/topology/flood.ipp>
#endif
