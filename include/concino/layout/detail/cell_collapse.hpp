// Collapses quads or hexes: cells between opposite cells vanish, and what they connect becomes one.
#pragma once

#include <concino/layout/detail/cell_patch.hpp>

namespace concino::detail {

/// A cell that vanishes. It connects two remaining cells of dimension `dim` that become one.
struct vanishing_cell {
  std::uint32_t a, b;
  std::uint8_t dim;
  bool is_odd;  // it connects them as an edge does, or as a cube; a square of such edges is even
  bool on_boundary;
};

struct cell_collapse {
  std::vector<vanishing_cell> vanishing;
  std::vector<unsigned char> gone_edges, gone_facets, gone_polys;
  explicit cell_collapse(const cube_tables& t)
      : gone_edges(t.num_edges), gone_facets(t.num_facets), gone_polys(t.num_polys()) {}
};

/// All cells that extend along marked edges vanish. Of parallel edges of a poly all are marked or none.
cell_collapse collapse_along(const cube_tables& t, const boundary_flags& boundary,
                             const std::vector<unsigned char>& is_marked);

/// A quad vanishes, in which the verts at place a and at the opposite place become one.
cell_collapse collapse_diagonal(const cube_tables& t, std::uint32_t p, unsigned a);

/// What becomes of the patch. It is refused if what is collapsed to one cell, or its part at the boundary, is not
/// contractible, a cell would have a vert twice, or two cells would have the same verts.
/// Verts that become one keep the most special place: that at a corner of the boundary, along its edge, on it.
cell_edit collapsed(const cube_tables& t, const boundary_flags& boundary, const std::vector<vec3>& points,
                    const cell_collapse& c);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/layout/detail/cell_collapse.ipp>
#endif
