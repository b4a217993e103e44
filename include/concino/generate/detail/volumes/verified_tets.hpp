// What tetrahedralize() returns is verified here: positive tets, the surface as their boundary, the enclosed volume.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/generate/detail/volumes/closed_surface.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

struct verified_tets {
  tetmesh mesh;
  std::vector<std::uint32_t> triangle_of_face;  // by index of the face: the triangle of the input that it lies in, or
                                                // no_triangle
  std::vector<std::uint32_t> vert_of_point;     // by point of the input: its vert, or no_vert
  std::vector<std::uint32_t> region_of_poly;    // by index of the poly: the position of its region among the options,
                                                // or no_region

  static constexpr std::uint32_t no_triangle = ~0u, no_vert = ~0u, no_region = ~0u;
};

/// Removes holes and what the surface does not enclose, and verifies the rest. `back_end` is its name in messages.
/// Errors: unsupported if the back end returned something else than was promised. invalid_argument if no tet contains
///         the point of a hole or region.
verified_tets verified(const closed_surface& surface, tetrahedralize_output output,
                       const tetrahedralize_options& options, const char* back_end);

/// The same for a back end that approximates the surface within a distance: its boundary has to be as near, and the
/// volume right to the area times the distance. Verts belong to points where they are equal; faces on the boundary
/// belong to the nearest triangle.
verified_tets verified_approximation(const closed_surface& surface, tetrahedralize_output output, double distance,
                                     const char* back_end);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/volumes/verified_tets.ipp>
#endif
