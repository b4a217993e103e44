// Checks that a correspondence fits its meshes; see correspondence.hpp.
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/correspondence.hpp>

namespace concino::detail {

CONCINO_INLINE void check_origins(element_kind kind, const element_origins& origins, std::size_t bound_before,
                                  std::size_t bound_after) {
  if (origins.size() != bound_after)
    core::throw_joined<invalid_argument>({"correspondence: the origins of ", origins.size(), " ", to_string(kind),
                                          "s are given, but the index bound of the mesh is ", bound_after});
  for (std::size_t i = 0; i < origins.size(); ++i)
    for (const origin x : origins[i])
      if (x.index >= bound_before)
        core::throw_joined<invalid_argument>({"correspondence: ", to_string(kind), " ", i, " was made of ",
                                              to_string(kind), " ", x.index,
                                              ", but the index bound of the mesh before is ", bound_before});
}

CONCINO_INLINE void check_origins(const correspondence& c, const property_set& properties, const index_bounds& before,
                                  const index_bounds& after) {
  const auto check = [&](element_kind kind, const element_origins& origins, std::size_t bound_before,
                         std::size_t bound_after) {
    if (properties.has(kind)) check_origins(kind, origins, bound_before, bound_after);
  };
  check(element_kind::vert, c.verts, before.verts, after.verts);
  check(element_kind::edge, c.edges, before.edges, after.edges);
  check(element_kind::face, c.faces, before.faces, after.faces);
  check(element_kind::poly, c.polys, before.polys, after.polys);
  check(element_kind::corner, c.corners, before.corners, after.corners);
}

}  // namespace concino::detail
