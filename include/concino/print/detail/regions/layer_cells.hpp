// The material of a layer on a lattice, as triangles and as simple polygons.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/slice_layer.hpp>
#include <concino/print/detail/regions/cell_triangles.hpp>
#include <concino/print/detail/regions/contour_reader.hpp>
#include <concino/print/detail/regions/lattice.hpp>
#include <concino/print/layer_options.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// Checks options and all points, and makes the lattice of slices.
/// Errors: invalid_argument that names an option, or layer and contour of a point.
lattice lattice_of(const char* caller, const slices& s, const layer_options& options, int bits);

/// Triangles of the material of a layer, and their kinds.
struct layer_cells {
  std::vector<snapped_point> points;  // of which triangles use some
  cell_triangles cells;
  std::vector<int> kinds;             // by triangle
};

/// How points are rounded once more: to multiples of 2^coarser units of the lattice, of which the result has 2^finer in
/// each.
struct rounding {
  int coarser = 0, finer = 0;
};
layer_cells cells_of_layer(const char* caller, const slice_layer& layer, const lattice& to,
                           const layer_options& options, const polygon_clipper& back_end, const rounding& round,
                           std::size_t index, slice_report& report);

/// Simple polygons that are unions of triangles of one kind; polygon i has the points before ends[i].
struct merged_polygons {
  std::vector<std::uint32_t> points;
  std::vector<std::size_t> ends;
  std::vector<int> kinds;
};
merged_polygons merge_triangles(const layer_cells& layer);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/print/detail/regions/layer_cells.ipp>
#endif
