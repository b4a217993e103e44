// Values on directed edges whose sums around triangles are 0, but not around all loops: a basis of the first cohomology.
#pragma once

#include <concino/core/compiled.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The edges and triangles of a mesh by index. An edge is directed from its first end.
struct edge_complex {
  struct triangle {
    std::array<std::uint32_t, 3> edge;
    std::array<double, 3> sign;  // 1 if the triangle is passed along the edge, -1 against it
  };
  std::size_t verts = 0;                            // the bound of their indices
  std::vector<std::array<std::uint32_t, 2>> edges;  // two equal ends where there is no edge
  std::vector<triangle> triangles;
};

/// As many as independent loops that no triangles fill (with real coefficients). Each is a value for each edge, by index; they are linearly independent, also modulo differences of values at
/// verts.
/// Cost:   O(size of the complex) times their number, if few values are to be chosen; see closed_cochains.ipp.
std::vector<std::vector<double>> closed_cochains(const edge_complex& complex);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/closed_cochains.ipp>
#endif
