// The lines of a section of a mesh: cleaned contours, each with the polys that it passes.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/slice_layer.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// A line, and by segment the number of the poly that it passes: from point i to i + 1, and if it is closed from the
/// last to the first.
struct section_line {
  std::vector<slice_point> points;
  std::vector<std::uint32_t> polys;

  void add(const slice_point& p, std::uint32_t poly) {
    points.push_back(p);
    polys.push_back(poly);
  }
};

/// The lists of polys of lines: line i passes those before ends[i], in order; neighbours differ.
struct section_polys {
  std::vector<std::uint32_t> polys;
  std::vector<std::size_t> ends;
};

/// The lines of one layer.
struct section_layer {
  slice_layer layer;
  section_polys outer, inner, open;

  /// Adds a contour with material to its left: an outer one if it is counter-clockwise. Points that repeat their
  /// neighbours and spikes are left out, and contours without area.
  void add_contour(section_line line, std::int32_t id);
  void add_open(const section_line& line, std::int32_t id);
};

/// A directed edge of a polygon of a section.
struct section_edge {
  std::uint32_t from, to, poly;
};

/// Joins edges that form closed cycles into cycles that pass no vert twice.
/// Needs:  as many edges leave each vert as enter it.      Result: by cycle, the numbers of edges.      Cost: O(n log
///         n).      Errors: none.
std::vector<std::vector<std::uint32_t>> simple_cycles(const std::vector<section_edge>& edges);

/// The x and y of a point; what interpolation made of 0 is 0 again.
slice_point section_point(double x, double y);

/// Errors: invalid_argument that names a height that is not finite.
void check_heights(const std::vector<double>& heights);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/print/detail/slices/section_lines.ipp>
#endif
