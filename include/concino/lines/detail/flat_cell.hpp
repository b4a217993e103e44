// The surface of a polyhedron as triangles in flat arrays, and where a line inside leaves it.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// A triangle of a face, counter-clockwise seen from outside.
struct cell_triangle {
  std::array<std::uint32_t, 3> corner{};  // of the cell
  std::array<std::uint32_t, 3> ring{};    // of the face: places in its cycle of verts, the same ones for both cells of the face
  std::uint32_t face = 0, number = 0;     // among the faces of the cell, among the triangles of the face
  std::uint32_t ring_size = 3;

  /// Whether the side from corner k to the next one is a diagonal of the face.
  bool is_diagonal(unsigned k) const {
    const std::uint32_t a = ring[k], b = ring[(k + 1) % 3];
    return (a + 1) % ring_size != b && (b + 1) % ring_size != a;
  }
};

struct flat_cell {
  std::vector<vec3> points;
  std::vector<cell_triangle> triangles;
};

/// Where a line leaves a cell: inside a triangle, on side k of it, or at corner k of it.
struct cell_exit {
  enum class kind { none, triangle, side, corner };
  kind at = kind::none;
  std::uint32_t triangle = 0, k = 0;
  double parameter = 0;  // on the side, from corner k to the next one
  vec3 position;
};

/// Where the line from x along g leaves the cell for the first time.
/// Needs: entry: the corners of the triangle (3), the edge (2) or the vert (1) at which x lies, or none, inside. x lies there but for rounding.
/// `none` if the line misses the cell, which happens if x is so near to the border of its triangle or edge that rounding put it outside.
cell_exit leave_cell(const flat_cell& cell, const vec3& x, const vec3& g, std::span<const std::uint32_t> entry);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/lines/detail/flat_cell.ipp>
#endif
