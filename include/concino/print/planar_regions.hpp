// Regions of the plane: outer contours with holes, islands in holes too.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/slice_layer.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino {

/// Regions whose interiors are disjoint. Each has an outer contour, counter-clockwise, and any number of holes,
/// clockwise; an island in a hole is a region of its own. Contours do not repeat their first point. Flat arrays:
/// contour i has the points before contour_ends[i], region r the contours before region_ends[r].
struct planar_regions {
  double unit = 0;  // coordinates are multiples of it, a power of two, in units of length; 0 if there is nothing
  std::vector<slice_point> points;
  std::vector<std::size_t> contour_ends;
  std::vector<std::size_t> region_ends;

  std::size_t size() const { return region_ends.size(); }
  bool empty() const { return region_ends.empty(); }
  std::size_t num_contours() const { return contour_ends.size(); }
  std::span<const slice_point> contour(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : contour_ends[i - 1];
    return {points.data() + begin, contour_ends[i] - begin};
  }
  /// The outer contour of region r, which its holes follow up to region_ends[r].
  std::size_t outer_contour(std::size_t r) const { return r == 0 ? 0 : region_ends[r - 1]; }
  std::size_t num_holes(std::size_t r) const { return region_ends[r] - outer_contour(r) - 1; }

  /// In units of length squared.
  double area() const;
};

/// The area within a contour, positive if it is counter-clockwise.
/// Needs:  a contour that does not repeat its first point.
/// Result: in units of length squared; of a contour that crosses itself, the sum of winding number times area.
/// Cost:   O(points).      Errors: none.
double contour_area(std::span<const slice_point> contour);

/// A layer with the contours of regions.
/// Needs:  nothing.
/// Result: outer and inner contours at height z, all with the given id.
/// Cost:   O(points).      Errors: none.
slice_layer to_layer(const planar_regions& regions, double z, std::int32_t id = 0);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/print/detail/regions/planar_regions.ipp>
#endif
