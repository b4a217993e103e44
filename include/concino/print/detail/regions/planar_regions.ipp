// Defines planar_regions.hpp.
#pragma once

#include <concino/print/planar_regions.hpp>

namespace concino {

CONCINO_INLINE double contour_area(std::span<const slice_point> contour) {
  double twice = 0;
  for (std::size_t i = 2; i < contour.size(); ++i) {
    const double ax = contour[i - 1][0] - contour[0][0], ay = contour[i - 1][1] - contour[0][1];
    const double bx = contour[i][0] - contour[0][0], by = contour[i][1] - contour[0][1];
    twice += ax * by - ay * bx;
  }
  return twice / 2;
}

CONCINO_INLINE double planar_regions::area() const {
  double sum = 0;
  for (std::size_t i = 0; i < num_contours(); ++i) sum += contour_area(contour(i));
  return sum;
}

CONCINO_INLINE slice_layer to_layer(const planar_regions& regions, double z, std::int32_t id) {
  slice_layer layer;
  layer.z = z;
  for (std::size_t r = 0; r < regions.size(); ++r)
    for (std::size_t i = regions.outer_contour(r); i < regions.region_ends[r]; ++i)
      (i == regions.outer_contour(r) ? layer.outer : layer.inner).push_back(regions.contour(i), id);
  return layer;
}

}  // namespace concino
