// Bodies of unused_dual_verts.hpp: dual verts that belong to no dual poly, and the descriptors in dual_maps.
#pragma once

#include <concino/generate/detail/dual/unused_dual_verts.hpp>

namespace concino::detail {

CONCINO_INLINE void drop_unused_dual_verts(std::vector<vec3>& points, std::vector<vert_id>& loops, dual_maps* maps) {
  constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> number(points.size(), none);
  for (const vert_id v : loops) number[v.raw()] = 0;
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (number[i] == none) continue;
    points[kept] = points[i];
    number[i] = kept++;
  }
  points.resize(kept);
  for (vert_id& v : loops) v = vert_id{number[v.raw()]};
  if (!maps) return;
  for (std::vector<vert_id>* map : {&maps->vert_of_poly, &maps->vert_of_face, &maps->vert_of_edge, &maps->vert_of_vert})
    for (vert_id& v : *map)
      if (!v.is_none()) v = vert_id{number[v.raw()]};
}

}  // namespace concino::detail
