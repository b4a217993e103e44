// The planes of polys: directions of their edges there, and angles between these.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/directions/detail/surface/oriented_surface.hpp>

#include <array>
#include <vector>

namespace concino::detail {

/// Polys are projected along the vectors of their areas. The axes of a plane are along its longest edge and
/// perpendicular, to the left.
struct poly_planes {
  std::vector<std::array<vec3, 2>> axes;  // by poly
  std::vector<double> along;              // by corner: the angle of the edge to the next corner
  std::vector<double> inside;             // by corner: the angle of the poly, from 0 to 2 pi

  explicit poly_planes(const oriented_surface& s);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/directions/detail/surface/poly_planes.ipp>
#endif
