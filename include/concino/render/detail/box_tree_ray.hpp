// The ray that queries of box_tree_tracer.hpp share.
#pragma once

#include <concino/core/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace concino::detail {

/// A ray in single precision, prepared for the tests of boxes and triangles.
struct box_tree_ray {
  float origin[3];
  float near_origin[3], far_origin[3];  // moved so that rounding never makes a ray miss the box of a triangle that it hits
  float inverse[3];                     // 1 / direction
  std::size_t near_row[3];              // of bounds: the plane that the ray meets first
  std::size_t x, y, z;                  // the axes, so that the direction is longest along z
  float shear_x, shear_y, scale_z;      // these map the direction to (0, 0, 1)

  box_tree_ray(const vec3& from, const vec3& direction, const std::array<float, 3>& low, const std::array<float, 3>& high) {
    float d[3], extent[3];
    for (std::size_t k = 0; k < 3; ++k) {
      origin[k] = static_cast<float>(from[k]);
      d[k] = static_cast<float>(direction[k]);
      extent[k] = std::max(std::abs(low[k] - origin[k]), std::abs(high[k] - origin[k]));
    }
    z = std::abs(d[1]) > std::abs(d[0]);
    z = std::abs(d[2]) > std::abs(d[z]) ? 2 : z;
    x = z == 2 ? 0 : z + 1;
    y = x == 2 ? 0 : x + 1;
    scale_z = 1 / d[z];
    shear_x = d[x] * scale_z;
    shear_y = d[y] * scale_z;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool negative = std::signbit(d[k]);
      const float least = 1e-18f * std::abs(d[z]);  // so that no product below is 0 times infinity
      if (!(std::abs(d[k]) > least)) d[k] = negative ? -least : least;
      inverse[k] = 1 / d[k];
      near_row[k] = 2 * k + negative;
      const float pad = 6 * 0x1p-24f * (extent[k] + extent[z]);
      near_origin[k] = negative ? origin[k] - pad : origin[k] + pad;
      far_origin[k] = negative ? origin[k] + pad : origin[k] - pad;
    }
  }
};

}  // namespace concino::detail
