// Pairs of extrema and saddles; see extremum_pairs.hpp.
#pragma once

#include <concino/fields/detail/topology/extremum_pairs.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

/// Verts are united with their earlier neighbours, in the order of the sweep. The root of a set is its smallest number,
/// so it is the extremum of the set; where two sets meet, the later extremum is paired with the vert at which they do.
CONCINO_INLINE std::vector<extremum_pair> find_extremum_pairs(const ranked_graph& g, bool of_maxima) {
  const std::uint32_t n = g.size();
  const auto turned = [&](std::uint32_t rank) { return of_maxima ? n - 1 - rank : rank; };
  std::vector<extremum_pair> pairs;
  disjoint_sets sets(n);
  for (std::uint32_t at = 0; at < n; ++at) {
    std::size_t root = at;
    for (const std::uint32_t neighbour : g.neighbours(turned(at))) {
      if (turned(neighbour) >= at) continue;
      const std::size_t other = sets.root(turned(neighbour));
      if (other == root) continue;
      const std::size_t later = std::max(root, other);
      root = sets.unite_roots(root, other);
      if (later == at) continue;  // the vert itself, which is no extremum
      const std::uint32_t extremum = turned(static_cast<std::uint32_t>(later)), saddle = turned(at);
      pairs.push_back({extremum, saddle, std::abs(g.value(saddle) - g.value(extremum))});
    }
  }
  for (std::uint32_t at = 0; at < n; ++at)
    if (sets.root(at) == at) pairs.push_back({turned(at), no_rank, std::numeric_limits<double>::infinity()});
  const auto comes_first = [&](const extremum_pair& a, const extremum_pair& b) {
    if (a.persistence != b.persistence) return a.persistence > b.persistence;
    if ((a.saddle == no_rank) != (b.saddle == no_rank)) return a.saddle == no_rank;
    return turned(a.extremum) < turned(b.extremum);
  };
  std::sort(pairs.begin(), pairs.end(), comes_first);
  return pairs;
}

}  // namespace concino::detail
