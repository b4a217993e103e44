// Where a line along a field leads on from a vert or an edge of a volume: into a cell, along a face, or along an edge.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Names a triangle of a face (its face's index and its number), an edge (its index and SIZE_MAX), or a diagonal (the
/// face's index and the places of its ends).
struct incident_key {
  std::size_t element = SIZE_MAX, part = SIZE_MAX;
  friend auto operator<=>(const incident_key&, const incident_key&) = default;
};

/// A triangle of the surface of a cell, with a corner at the vert; a and b: its other corners, counter-clockwise seen
/// from outside the cell.
struct incident_triangle {
  vec3 a, b;
  incident_key face, side_a, side_b;  // the triangle, the sides from the vert to a and to b
};

struct incident_cell {
  vec3 field;
  std::vector<incident_triangle> triangles;  // those at the vert, or those at the edge
};

struct volume_exit {
  enum class kind { none, cell, triangle, edge, edge_back };  // edge: to its far end; edge_back: to the vert
  kind to = kind::none;
  std::size_t cell = 0, triangle = 0;  // the triangle in the cell; for edges a triangle with side_a or side_b along the
                                       // edge
  bool along_a = false;
  vec3 velocity;                       // of a triangle: along its face
};

/// From a vert. Of all cells, triangles and edges that lead away from it, the fastest; of several, the one whose
/// velocity comes first in `lies_before`. A triangle leads on if the fields of both its cells push towards it or are
/// parallel to it, an edge if no cell and no triangle leads away from it.
volume_exit steepest_exit(const vec3& from, std::span<const incident_cell> cells);

/// From a place on an edge, or a diagonal, between the vert `from` and the point `to`.
volume_exit steepest_exit(const vec3& from, const vec3& to, const incident_key& edge,
                          std::span<const incident_cell> cells);

/// The velocity along a triangle, of fields that push towards it from both sides.      Source: Filippov 1988, as
/// sliding_speed.
vec3 sliding_velocity(double push1, const vec3& field1, double push2, const vec3& field2, const vec3& normal);

/// How fast a field leaves its cell through a triangle; 0 if it does not.
double push_through(const vec3& field, const vec3& p, const vec3& q, const vec3& r);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/lines/detail/cells/volume_exits.ipp>
#endif
