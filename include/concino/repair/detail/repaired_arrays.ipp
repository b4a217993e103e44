// Bodies of repaired_arrays.hpp: the verts that remain, and their origins.
#pragma once

#include <concino/repair/detail/repaired_arrays.hpp>

#include <numeric>
#include <utility>

namespace concino::detail {

/// The new number of each vert; ~0u if it is removed: because it became another one, or because it is not in `used` and
/// is unreferenced.
inline std::vector<std::uint32_t> number_verts(const std::vector<vec3>& points,
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

/// The origins of the verts that remain: all verts before of their clusters, or those that are listed for new verts.
inline element_origins origins_of_verts(const std::vector<std::uint32_t>& number,
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

CONCINO_INLINE surface_lists lists_of(surface_arrays a) {
  surface_lists s;
  s.points = std::move(a.points);
  s.offsets = std::move(a.offsets);
  s.verts.reserve(a.verts.size());
  for (const vert_id v : a.verts) s.verts.push_back(v.raw());
  s.poly_origin.resize(s.num_polys());
  std::iota(s.poly_origin.begin(), s.poly_origin.end(), 0u);
  s.is_turned.resize(s.num_polys());
  s.vert_origin.resize(s.points.size());
  std::iota(s.vert_origin.begin(), s.vert_origin.end(), 0u);
  s.cluster = s.vert_origin;
  return s;
}

CONCINO_INLINE repaired_arrays<surface_arrays> arrays_of_lists(surface_lists s, std::uint32_t arity,
                                                               bool remove_unreferenced, repair_log& log) {
  repaired_arrays<surface_arrays> result;
  const std::vector<std::uint32_t> number =
      number_verts(s.points, s.vert_origin, s.cluster, s.verts, remove_unreferenced, log);
  result.verts = origins_of_verts(number, s.vert_origin, s.cluster, s.of_new_verts);
  result.polys = element_origins(std::move(s.poly_origin));
  surface_arrays& a = result.arrays;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != surface_lists::none) a.points.push_back(s.points[v]);
  a.verts.reserve(s.verts.size());
  for (const std::uint32_t v : s.verts) a.verts.push_back(vert_id{number[v]});
  a.arity = arity;
  if (arity == 0) a.offsets = std::move(s.offsets);
  result.cluster = std::move(s.cluster);
  return result;
}

}  // namespace concino::detail
