// Walks straight over triangles that are unfolded one after the other. On flat arrays only.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/unfolded_triangles.hpp>
#include <concino/lines/line_end.hpp>

#include <cstddef>
#include <vector>

namespace concino::detail {

/// A point of a walk: at a vert, on the side of a triangle, or inside a triangle.
struct walk_stop {
  int vert = -1;      // or -1
  int side = -1;      // or -1; inside triangle side / 3 if is_inside
  double along = 0;   // on a side: from its start, as a fraction; inside: along the side, in units of the triangles
  double inward = 0;  // inside: perpendicular to the side
  bool is_inside = false;
};

/// A place in a triangle and a direction of length 1, in the frame of side `side`: x along it from its start, y into
/// the triangle.
struct walk_state {
  int side = -1;
  double x = 0, y = 0, dx = 1, dy = 0;
  enum class location { inside, on_side, at_start } where = location::inside;  // at_start: of the side
};

struct walk_result {
  std::vector<walk_stop> stops;  // without the start
  double length = 0;
  walk_state last;               // its direction is that at the end
  line_end stopped_by = line_end::max_length;
};

/// The sector at vert v, a closed fan or an open one, that contains the direction at this angle in the fan, any
/// multiple of a whole turn added; side -1 if the direction leads out of the surface. full_turn: the angle that may be
/// added, the whole turn or, at the boundary, 2 pi.
walk_state leave_vert(const core::unfolded_triangles& t, int v, double fan_angle, double full_turn);

/// Walks from a place with side >= 0.
walk_result walk_straight(const core::unfolded_triangles& t, walk_state from, double length, std::size_t max_steps);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/lines/detail/geodesics/geodesic_walker.ipp>
#endif
