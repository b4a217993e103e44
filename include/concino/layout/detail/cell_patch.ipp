// Bodies of cell_patch.hpp: cell_patch: the quads or hexes about some elements of a mesh as cube_tables, and cell_edit:
// what becomes of them.
#pragma once

#include <concino/layout/detail/cell_patch.hpp>

namespace concino::detail {

CONCINO_INLINE boundary_flags::boundary_flags(const cube_tables& t)
    : verts(t.num_verts), edges(t.num_edges), facets(t.num_facets) {
  const unsigned all = t.num_corners() - 1;
  for (std::size_t p = 0; p < t.num_polys(); ++p)
    for (unsigned place = 0; place < t.num_poly_facets(); ++place) {
      if (t.at_facets.count(t.facet(p, place)) != 1) continue;
      facets[t.facet(p, place)] = 1;
      const unsigned normal = 1u << (place / 2), at = place & 1 ? normal : 0;
      for (unsigned k = 0; k <= all; ++k) {
        if ((k & normal) != at) continue;
        verts[t.cell(p, 0, k)] = 1;
        for (unsigned axis = 1; axis <= all; axis *= 2)
          if (axis != normal) edges[t.cell(p, axis, k & ~axis)] = 1;
      }
    }
}

CONCINO_INLINE std::uint32_t cell_edit::add_vert(const cube_tables& t, const vec3& x,
                                                 const std::vector<std::uint32_t>& from) {
  points.push_back(x);
  origins.insert(origins.end(), from.begin(), from.end());
  origin_ends.push_back(static_cast<std::uint32_t>(origins.size()));
  return static_cast<std::uint32_t>(t.num_verts + points.size() - 1);
}

}  // namespace concino::detail
