// The polys that take the place of those that a level set cuts, as lists for rewire.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/level_sets/detail/cut/cell_parts.hpp>
#include <concino/level_sets/detail/cut/poly_parts.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// Verts have local numbers: first existing ones, then new ones.
struct embedding_lists {
  std::vector<std::uint32_t> old_polys;      // numbers of crossed polys that change, ascending
  std::vector<std::uint32_t> verts;          // existing verts of these, as numbers of crossed verts
  std::vector<std::uint32_t> places;         // of the new verts
  std::vector<unsigned> corners, ends, poly_ends;  // of the new polys, as in cavity; poly_ends of polyhedra only
  std::vector<std::uint32_t> origins;        // by new poly: the position of the old one in old_polys; the first new
                                             // polys are one of each old one
  std::vector<std::uint32_t> cut_places, cut_ends;  // the edges, or the faces, on the level set, as places
  std::vector<std::uint32_t> number_of_place;  // by place: its position in `places`
};

/// The parts of polygons. triangulate: cut into triangles, by diagonals at the vert with the smallest number.
embedding_lists list_embedding(const poly_parts& parts, const crossed_surface& s, bool triangulate);

/// The parts of cells. triangulate: faces are cut by diagonals at their verts with the smallest numbers, so that both
/// cells at one agree, and convex parts into the tets between their vert with the smallest number and the triangles of
/// faces that do not have it.
embedding_lists list_embedding(const cell_parts& parts, const crossed_volume& v, bool triangulate);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/embed/embedding_lists.ipp>
#endif
