// The distortion of a map to the plane, from flat arrays.
#pragma once

#include <concino/parametrize/detail/poly_triangles.hpp>

#include <vector>

namespace concino::detail {

/// By poly, see map_distortion_result.
struct flat_distortion {
  std::vector<double> angle, area, stretch;
  std::vector<unsigned char> is_flipped;
  double max_angle = 0, mean_angle = 0, min_area = 1, max_area = 1, max_stretch = 1, scale = 0;
};

/// uv: by corner.      Errors: invalid_argument if one is not finite.
flat_distortion distortion_of(const flat_polys& f, std::vector<uv_point> uv);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/parametrize/detail/distortion.ipp>
#endif
