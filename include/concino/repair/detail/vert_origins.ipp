// Bodies of vert_origins.hpp.
#pragma once

#include <concino/repair/detail/vert_origins.hpp>

namespace concino::detail {

CONCINO_INLINE std::vector<std::uint32_t> number_verts(const std::vector<vec3>& points,
                                                       const std::vector<std::uint32_t>& vert_origin,
                                                       const std::vector<std::uint32_t>& cluster,
                                                       const std::vector<std::uint32_t>& used, bool remove_unreferenced,
                                                       repair_log& log) {
  constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> number(points.size(), none);
  for (const std::uint32_t v : used) number[v] = 0;
  for (std::uint32_t v = 0; v < cluster.size(); ++v) {
    if (cluster[v] != v || number[v] != none) continue;
    if (!remove_unreferenced) number[v] = 0;
    else log.add(repair_kind::removed_verts, v);
  }
  std::uint32_t n = 0;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != none || (v >= cluster.size() && vert_origin[v] == none)) number[v] = n++;
  return number;
}

CONCINO_INLINE element_origins origins_of_verts(const std::vector<std::uint32_t>& number,
                                                const std::vector<std::uint32_t>& vert_origin,
                                                const std::vector<std::uint32_t>& cluster,
                                                const std::vector<std::vector<std::uint32_t>>& of_new_verts) {
  constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> next(cluster.size(), none);  // the members of a cluster after the first, a ring
  for (std::uint32_t v = 0; v < cluster.size(); ++v) {
    const std::uint32_t first = cluster[v];
    if (first == v) continue;
    next[v] = next[first] == none ? first : next[first];
    next[first] = v;
  }
  element_origins origins;
  std::vector<origin> all;
  std::size_t num_new = 0;
  const auto add_cluster = [&](std::uint32_t first) {
    all.push_back({first});
    if (next[first] != none)
      for (std::uint32_t v = next[first]; v != first; v = next[v]) all.push_back({v});
  };
  for (std::size_t v = 0; v < number.size(); ++v) {
    const std::uint32_t first = vert_origin[v];
    const std::size_t which = num_new;
    num_new += first == none;
    if (number[v] == none) continue;
    if (first != none && next[first] == none) {
      origins.add(first);
      continue;
    }
    all.clear();
    if (first != none) add_cluster(first);
    else
      for (const std::uint32_t x : of_new_verts[which])
        if (x != none) add_cluster(x);
    origins.add(all);
  }
  return origins;
}

}  // namespace concino::detail
