// Pairs of extrema and saddles of a function on a graph.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/fields/detail/topology/sorted_graph.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

struct extremum_pair {
  std::uint32_t extremum, saddle;  // ranks; no_rank for the saddle of the lowest minimum or highest maximum of a
                                   // component
  double persistence;
};

/// The pairs of minima, or of maxima, by falling persistence; of equal ones, the earlier in the sweep comes first.
std::vector<extremum_pair> find_extremum_pairs(const ranked_graph& g, bool of_maxima);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/topology/extremum_pairs.ipp>
#endif
