// Inserts a layer of quads or hexes between the two sides of some facets.
#pragma once

#include <concino/layout/detail/cell_patch.hpp>

namespace concino::detail {

inline constexpr permission facet_of_many{refusal::wrong_number, "a facet has no poly, or more than two"};

/// What becomes of the patch about the marked facets, which are listed too: the polys on one side of them and on the
/// other have verts of their own, and there is a poly for each facet between. Outside of the mesh is a side as well.
/// It is refused if the facets do not separate two sides at each of their verts.
/// thickness: by which part of the polys beside them the new ones push these back.
cell_edit inserted(const cube_tables& t, const boundary_flags& boundary, const std::vector<vec3>& points,
                   const std::vector<std::uint32_t>& facets, double thickness);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/layout/detail/cell_insertion.ipp>
#endif
