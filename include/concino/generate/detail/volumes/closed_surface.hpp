// The surface that tetrahedralize() fills: as flat arrays, checked, oriented and cut into triangles.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/generate/detail/volumes/polygon_arrays.hpp>
#include <concino/generate/tetrahedralize_options.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// A surface that was checked, ready for a back end.
struct closed_surface {
  tetrahedralize_input input;
  std::vector<std::uint32_t> poly_of_triangle;  // by position
  std::vector<std::uint32_t> not_planar;        // indices of polys
  double volume = 0;                            // enclosed; parts enclosed several times count as often
};

/// Orients the polys alike, cuts them into triangles, and adds the extra points, segments and facets.
/// Errors: invalid_mesh if a point is not finite, two points coincide, a poly has no area or repeats a vert, an edge
///         has one poly or more than two, the surface has only one side, all points lie in one plane, or triangles
///         intersect. invalid_argument if an option is out of its range.
closed_surface checked_surface(polygon_arrays polygons, const tetrahedralize_options& options);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/volumes/closed_surface.ipp>
#endif
