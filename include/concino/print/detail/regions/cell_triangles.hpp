// Triangles of the cells of an arrangement, with the values of two integer functions.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/print/detail/regions/arrangement.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Triangles where a function is not 0, counter-clockwise, through the points of the arrangement.
struct cell_triangles {
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::int64_t, 2>> values;
  std::vector<std::array<std::uint32_t, 3>> neighbours;  // across the side from corner k to k + 1; none where both
                                                         // functions are 0 behind it
};

/// Triangulates the cells of an arrangement. The functions are 0 far away, and change at edges by their steps.
/// Needs:  an arrangement of closed paths.      Cost: O(n log n), and O(1) for each of the flips that make the
///         triangles Delaunay within cells.      Errors: none.
/// Source: Lawson 1977 for the flips: they leave no flat triangle at a point where rounding has bent a line.
cell_triangles triangulate_cells(const planar_arrangement& a);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/print/detail/regions/cell_triangles.ipp>
#endif
