// Bodies of handle_positions.hpp: handles of a deformation and their positions, as arrays by index of verts, with
// checks.
#pragma once

#include <concino/core/number_text.hpp>
#include <concino/deform/detail/arap/handle_positions.hpp>

namespace concino::detail {

CONCINO_INLINE void throw_no_handle_vert(const char* caller) {
  core::throw_joined<invalid_mesh>({caller, ": a handle is no vert of the mesh"});
}
CONCINO_INLINE void throw_other_position(const char* caller, std::size_t vert) {
  core::throw_joined<invalid_argument>({caller, ": vert ", vert, " is given two different positions"});
}
CONCINO_INLINE void throw_no_handles(const char* caller) {
  core::throw_joined<invalid_argument>({caller, ": there are no handles"});
}
CONCINO_INLINE void throw_not_a_handle(std::size_t vert) {
  core::throw_joined<invalid_argument>(
      {"with_positions: vert ", vert, " is given a position, but it is no handle; pass it to prepare_deform"});
}
CONCINO_INLINE void throw_no_position(std::size_t vert) {
  core::throw_joined<invalid_argument>({"with_positions: vert ", vert, " is a handle, but is given no position"});
}
CONCINO_INLINE void check_limits(int max_iterations, double tolerance) {
  if (max_iterations < 0)
    core::throw_joined<invalid_argument>(
        {"with_positions: max_iterations is ", core::number_text(max_iterations), "; it must be 0 or more"});
  if (!(tolerance >= 0 && tolerance <= 1))
    core::throw_joined<invalid_argument>(
        {"with_positions: tolerance is ", core::number_text(tolerance), "; it must be from 0 to 1"});
}

}  // namespace concino::detail
