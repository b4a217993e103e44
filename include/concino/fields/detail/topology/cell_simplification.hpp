// Simplifies functions on the cells of a surface, minima and maxima at once.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/fields/detail/topology/sorted_graph.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The edges and polys of a surface, numbered in the order of iteration.
struct surface_cells {
  std::vector<std::array<std::uint32_t, 2>> edge_verts;  // ranks
  std::vector<std::array<std::uint32_t, 2>> edge_polys;  // no_rank where there are fewer than two
  std::size_t polys = 0;
};

struct simplified_cells {
  std::vector<double> verts, edges, polys;  // by rank and by number
  std::array<std::size_t, 3> critical{};    // how many critical cells of each dimension remain
};

/// values: by rank. At edges and polys, the function has the value of the highest vert.
simplified_cells simplify_cells(const surface_cells& cells, const std::vector<double>& values, double threshold);

void check_cell_threshold(double threshold);
[[noreturn]] void throw_non_manifold_edge(std::size_t edge);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/topology/cell_simplification.ipp>
#endif
