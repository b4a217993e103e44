// Where a line along a field leads on from a point of a surface: into a triangle around it, or along an edge.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace concino::detail {

/// A triangle with a corner at the point. a and b: its other corners, counter-clockwise seen from where the normal
/// points to.
struct surface_sector {
  vec3 a, b, normal, field;
  std::size_t side_a = 0, side_b = 0;  // what tells the sides from the point to a and to b from others
};

struct surface_exit {
  enum class kind { none, sector, side_a, side_b };  // into a sector, or along one of its sides
  kind to = kind::none;
  std::size_t sector = 0;
};

/// Of the triangles into which their own fields lead, and the sides along which the fields of both triangles push
/// together, the one with the greatest speed; of several, the one with the point first in the order of `lies_before`.
surface_exit steepest_exit(const vec3& from, std::span<const surface_sector> sectors);

/// The speed along a side from a to b, if the fields of its two triangles push against each other there: the mean of
/// both whose part across the side is 0.
/// Needs: speed1 and speed2, the speeds towards the side, 0 or more; along1 and along2, those along it.
/// Source: Filippov 1988, "Differential equations with discontinuous righthand sides".
double sliding_speed(double speed1, double along1, double speed2, double along2);

/// The length of the part of a field in the plane with this normal.
double speed_in_plane(const vec3& field, const vec3& normal);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/lines/detail/cells/surface_exits.ipp>
#endif
