// Raises values around minima; see flood.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/fields/detail/topology/extremum_pairs.hpp>
#include <concino/fields/detail/topology/flood.hpp>

#include <cmath>
#include <limits>
#include <queue>

namespace concino::detail {

CONCINO_INLINE void check_thresholds(double minima_below, double maxima_below) {
  const auto check = [](const char* name, double threshold) {
    if (!(threshold >= 0))
      core::throw_joined<invalid_argument>(
          {"simplified: ", name, " is ", core::number_text(threshold), "; it must be 0 or more"});
  };
  check("minima_below", minima_below);
  check("maxima_below", maxima_below);
  if ((minima_below > 0) == (maxima_below > 0))
    throw invalid_argument(
        "simplified: one of minima_below and maxima_below must be above 0, and only one; simplify the result again for the other");
}

/// The verts are visited from the kept minima on, lowest first. A vert that is lower than the one from which it is
/// visited gets the least value that is higher in the order of values and indices, so that each visited vert has a
/// lower neighbour.
CONCINO_INLINE std::vector<double> flooded_values(const ranked_graph& g, double threshold, bool of_maxima) {
  struct entry {
    double value;
    std::uint32_t index, rank;
    // the lowest is on top
    bool operator<(const entry& o) const { return value > o.value || (value == o.value && index > o.index); }
  };
  const double sign = of_maxima ? -1 : 1;
  const auto unchanged = [&](std::uint32_t rank) {
    return entry{sign * g.value(rank), of_maxima ? ~g.verts.index[rank] : g.verts.index[rank], rank};
  };
  std::vector<double> values = g.verts.values;
  std::vector<unsigned char> is_visited(g.size());
  std::priority_queue<entry> waiting;
  for (const extremum_pair& p : find_extremum_pairs(g, of_maxima)) {
    if (p.persistence < threshold) continue;
    is_visited[p.extremum] = 1;
    waiting.push(unchanged(p.extremum));
  }
  while (!waiting.empty()) {
    const entry at = waiting.top();
    waiting.pop();
    for (const std::uint32_t neighbour : g.neighbours(at.rank)) {
      if (is_visited[neighbour]) continue;
      is_visited[neighbour] = 1;
      entry next = unchanged(neighbour);
      if (at < next)
        next.value =
            next.index > at.index ? at.value : std::nextafter(at.value, std::numeric_limits<double>::infinity());
      values[neighbour] = sign * next.value;
      waiting.push(next);
    }
  }
  return values;
}

}  // namespace concino::detail
