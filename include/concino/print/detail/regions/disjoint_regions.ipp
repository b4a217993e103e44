// Defines disjoint_regions.hpp.
#pragma once

#include <concino/print/detail/regions/cell_triangles.hpp>
#include <concino/print/detail/regions/disjoint_regions.hpp>

#include <algorithm>

namespace concino::detail {

/// By triangle: the number of the connected part that it belongs to.
inline std::vector<std::uint32_t> parts_of_cells(const cell_triangles& cells, std::uint32_t& count) {
  std::vector<std::uint32_t> part(cells.triangles.size(), cell_triangles::none), open;
  count = 0;
  for (std::uint32_t first = 0; first < part.size(); ++first) {
    if (part[first] != cell_triangles::none) continue;
    part[first] = count;
    open.assign(1, first);
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (const std::uint32_t u : cells.neighbours[t])
        if (u != cell_triangles::none && part[u] == cell_triangles::none) {
          part[u] = count;
          open.push_back(u);
        }
    }
    ++count;
  }
  return part;
}

CONCINO_INLINE std::optional<lattice_regions> disjoint_regions(const lattice_paths& paths) {
  if (paths.size() == 0) return lattice_regions{};
  if (meet(paths)) return std::nullopt;
  stepped_segments all;
  all.add_paths(paths, {1, 0});
  const planar_arrangement a = arrange("disjoint_regions", all);
  const cell_triangles cells = triangulate_cells(a);
  if (std::any_of(cells.values.begin(), cells.values.end(), [](const auto& v) { return v[0] != 1; }))
    return std::nullopt;

  std::uint32_t num_parts = 0;
  const std::vector<std::uint32_t> part = parts_of_cells(cells, num_parts);
  std::vector<std::uint32_t> path_at(a.points.size(), cell_triangles::none),
      part_of(paths.size(), cell_triangles::none);
  for (std::uint32_t i = 0; i < paths.size(); ++i) path_at[i == 0 ? 0 : paths.ends[i - 1]] = i;
  for (std::size_t t = 0; t < part.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (const std::uint32_t p = cells.triangles[t][k], i = path_at[p];
          i != cell_triangles::none && cells.triangles[t][(k + 1) % 3] == p + 1)
        part_of[i] = part[t];

  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < paths.size(); ++i) order.push_back(i);
  const auto area = [&](std::uint32_t i) {
    double sum = 0;
    const auto path = paths[i];
    for (std::size_t k = 2; k < path.size(); ++k)
      sum += static_cast<double>(path[k - 1][0] - path[0][0]) * static_cast<double>(path[k][1] - path[0][1]) -
             static_cast<double>(path[k - 1][1] - path[0][1]) * static_cast<double>(path[k][0] - path[0][0]);
    return sum;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return part_of[i] != part_of[j] ? part_of[i] < part_of[j] : (area(i) > 0) > (area(j) > 0);
  });
  lattice_regions result;
  for (std::size_t k = 0; k < order.size(); ++k) {
    result.paths.push_back(paths[order[k]]);
    if (k + 1 == order.size() || part_of[order[k + 1]] != part_of[order[k]])
      result.region_ends.push_back(result.paths.size());
  }
  return result;
}

}  // namespace concino::detail
