// Maps of disks to the plane without flips, by steps that keep the areas of triangles positive, from flat arrays.
#pragma once

#include <concino/parametrize/detail/rigid_map.hpp>

namespace concino::detail {

/// See injective_map. start: empty for that of tutte.
iterated_map flip_free_map(const flat_disk& f, plane_points start, bool fixed_boundary, const iteration_limits& limits);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/parametrize/detail/flip_free_map.ipp>
#endif
