// Finds the points of two meshes that coincide.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// For each of `points`, the position of the nearest one of `among` within the distance `tolerance`, the first of
/// several; ~0u if there is none.
std::vector<std::uint32_t> coincident_points(std::span<const vec3> among, std::span<const vec3> points,
                                             double tolerance);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/unite/coincident_points.ipp>
#endif
