// The cells at a vert or an edge as triangles, and where a line leads on among them.
#pragma once

#include <concino/core/vec3.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
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

/// A cell at the vert or at the edge.
struct incident_cell {
  vec3 field;
  std::vector<incident_triangle> triangles;  // those at the vert, or those at the edge
};

/// Where a line leads on from a vert or an edge.
struct volume_exit {
  enum class kind { none, cell, triangle, edge, edge_back };  // edge: to its far end; edge_back: to the vert
  kind to = kind::none;
  std::size_t cell = 0, triangle = 0;  // the triangle in the cell; for edges a triangle with side_a or side_b along the
                                       // edge
  bool along_a = false;
  vec3 velocity;                       // of a triangle: along its face
};

}  // namespace concino::detail
