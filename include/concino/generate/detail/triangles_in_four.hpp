// The tables of triangles that are each split into four.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/surface_tables.hpp>

#include <cstdint>

namespace concino::detail {

/// Triangles by the numbers of their verts and edges. Three corners are a triangle: a vert, and the edge from there to the next vert.
struct numbered_triangles {
  struct corner {
    std::uint32_t vert, edge;
  };
  std::size_t num_verts = 0, num_edges = 0;
  core::flat_array<corner> corners;
};

/// The tables of triangles 4 i to 4 i + 3 for each triangle i: one at each of its verts, and the one in the middle. Verts keep their numbers, those at the
/// middle of edges follow. The tables are those that surface_tables would build from the verts of all triangles. In most surfaces they follow from the numbers of the
/// coarse edges, so that no edge need be searched; the others are built.
/// Errors: invalid_mesh if a triangle lists an edge twice.
surface_tables<3> triangles_in_four(numbered_triangles triangles);

/// Whether no edge is searched: edges have at most two triangles, which agree on its ends, and no two triangles have two edges in common.
bool has_derived_tables(const numbered_triangles& triangles);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/triangles_in_four.ipp>
#endif
