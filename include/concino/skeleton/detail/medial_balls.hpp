// For each vert of a closed surface, a large ball inside the surface that touches it at the vert.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// A ball about a point of the medial axis of a surface.
struct medial_ball {
  vec3 centre;
  double radius = 0;  // 0 if none is known
};

/// Needs:  a closed, oriented surface; a normal may point inside if all do.
/// Result: by point, a ball inside the surface, except where the surface is bent by less than about 35 degrees. It
///         begins with half of the chord along the normal, and shrinks until it is inside.
/// Cost:   O(n log n) for n points that are well distributed.
/// Source: Ma, Bae and Choi 2012, "3D medial axis point approximation using nearest neighbors and the normal field".
std::vector<medial_ball> medial_balls(const std::vector<vec3>& points,
                                      const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/skeleton/detail/medial_balls.ipp>
#endif
