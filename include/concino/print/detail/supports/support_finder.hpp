// Finds the triangles below others, to measure the supports between them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/print/detail/supports/supports.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Finds the triangles that face up by the place in the plane, in a grid whose cells have the shape of the boxes of
/// triangles. Its axes are turned where most edges are parallel, so that long triangles have slender boxes.
class support_finder {
  std::vector<height_triangle> floors_;
  std::vector<std::uint32_t> cell_offsets_, cells_;
  std::size_t columns_ = 1, lines_ = 1;
  double left_ = 0, bottom_ = 0, cell_width_ = 1, cell_height_ = 1;
  double cosine_ = 1, sine_ = 0;  // of the angle of the axes
  double plate_, tolerance_;

  struct cell_range {
    std::size_t i0, i1, j0, j1;
  };
  struct extents {
    double x0, x1, y0, y1;
  };
  extents extents_of(const height_triangle& t) const;
  cell_range cells_of(const height_triangle& t) const;
  void turn_axes();
  void build_grid();

 public:
  /// Coordinates are those of a build_frame, of a size of about 1. All triangles are above the plate.
  support_finder(std::vector<height_triangle> floors, double plate, double tolerance);

  supports_size below(const height_triangle& ceiling) const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/print/detail/supports/support_finder.ipp>
#endif
