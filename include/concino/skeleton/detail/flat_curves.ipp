// Defines flat_curves.hpp.
#pragma once

#include <concino/skeleton/detail/flat_curves.hpp>

#include <utility>

namespace concino::detail {

CONCINO_INLINE std::vector<std::vector<std::uint32_t>> bone_walks(const flat_curves& g) {
  const std::size_t n = g.points.size();
  std::vector<std::vector<std::uint32_t>> walks;
  std::vector<std::uint8_t> is_used(g.neighbours.size(), 0);  // edges, from each of their ends
  const auto use = [&](std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t i = g.first[from]; i < g.first[from + 1]; ++i)
      if (g.neighbours[i] == to) is_used[i] = 1;
  };
  const auto walk_along = [&](std::uint32_t start, std::uint32_t edge) {
    std::vector<std::uint32_t> walk{start};
    std::uint32_t from = start, to = g.neighbours[edge];
    while (true) {
      use(from, to);
      use(to, from);
      walk.push_back(to);
      if (to == start || g.num_neighbours(to) != 2) break;
      const std::uint32_t i = g.first[to], next = g.neighbours[g.neighbours[i] == from ? i + 1 : i];
      from = std::exchange(to, next);
    }
    walks.push_back(std::move(walk));
  };
  for (const bool cycles : {false, true})  // what remains is cycles of verts with two neighbours
    for (std::uint32_t v = 0; v < n; ++v)
      if ((g.num_neighbours(v) == 2) == cycles)
        for (std::uint32_t i = g.first[v]; i < g.first[v + 1]; ++i)
          if (!is_used[i]) walk_along(v, i);
  return walks;
}

CONCINO_INLINE bone_curve curve_along(const flat_curves& g, const std::vector<std::uint32_t>& walk) {
  bone_curve curve;
  for (const std::uint32_t v : walk) {
    curve.points.push_back(g.points[v]);
    if (!g.radii.empty()) curve.radii.push_back(g.radii[v]);
  }
  return curve;
}

}  // namespace concino::detail
