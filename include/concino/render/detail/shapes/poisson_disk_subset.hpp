// Chooses some of many points so that they are evenly distributed.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// At most `count` of the points, or somewhat fewer, no two of them near each other; all if there are not more.
/// Ascending, and the same in every run.
/// Needs:  finite points.      Cost: O(n log n).
/// Source: random sequential addition; the distance is found by bisection.
std::vector<std::uint32_t> poisson_disk_subset(std::span<const vec3> points, std::size_t count);

/// The mean distance from a point to the nearest other one, of up to 256 of the points; 0 if all coincide.
double mean_distance(std::span<const vec3> points);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/shapes/poisson_disk_subset.ipp>
#endif
