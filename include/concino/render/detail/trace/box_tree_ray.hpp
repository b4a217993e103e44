// The ray that queries of box_tree_tracer.hpp share.
#pragma once

#include <concino/render/ray_caster.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace concino::detail {

/// A ray in single precision, prepared for the tests of boxes and triangles.
struct box_tree_ray {
  float origin[3];
  float near_origin[3], far_origin[3];  // moved so that rounding never makes a ray miss the box of a triangle that it
                                        // hits
  float inverse[3];                     // 1 / direction
  bool negative[3];                     // the ray meets the larger bound first
  std::size_t x, y, z;                  // the axes, so that the direction is longest along z
  float shear_x, shear_y, scale_z;      // these map the direction to (0, 0, 1)

  box_tree_ray(const vec3& from, const vec3& direction, const float (&low)[3], const float (&high)[3]) {
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
      negative[k] = std::signbit(d[k]);
      const float least = 1e-18f * std::abs(d[z]);  // so that no product below is 0 times infinity
      if (!(std::abs(d[k]) > least)) d[k] = negative[k] ? -least : least;
      inverse[k] = 1 / d[k];
      const float pad = 6 * 0x1p-24f * (extent[k] + extent[z]);
      near_origin[k] = negative[k] ? origin[k] - pad : origin[k] + pad;
      far_origin[k] = negative[k] ? origin[k] + pad : origin[k] - pad;
    }
  }

  /// The parameter at which the ray enters a box, or infinity if that is not in [near, far].
  float entry(const float (&bounds)[2][3], float near, float far) const {
    constexpr float more = 1 + 6 * 0x1p-24f;  // for the rounding of the two parameters
    float first = near, last = std::numeric_limits<float>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      first = std::max(first, (bounds[negative[k]][k] - near_origin[k]) * inverse[k]);
      last = std::min(last, (bounds[!negative[k]][k] - far_origin[k]) * inverse[k]);
    }
    return first <= std::min(last * more, far) ? first : std::numeric_limits<float>::infinity();
  }

  /// Replaces `best` if the triangle is hit with a parameter in [t_near, best.t]; of several at the same parameter the
  /// lowest number stays.
  void test(const float (&corner)[3][3], std::uint32_t number, double t_near, ray_hit& best) const {
    float px[3], py[3], pz[3];
    for (std::size_t c = 0; c < 3; ++c) {
      pz[c] = corner[c][z] - origin[z];
      px[c] = (corner[c][x] - origin[x]) - shear_x * pz[c];
      py[c] = (corner[c][y] - origin[y]) - shear_y * pz[c];
    }
    // Products of two floats are exact in double precision. So the signs are exact, and the triangles on both sides of
    // an edge agree about it.
    const auto determinant = [&](std::size_t i, std::size_t j) {
      return static_cast<double>(px[i]) * static_cast<double>(py[j]) -
             static_cast<double>(py[i]) * static_cast<double>(px[j]);
    };
    const double u = determinant(2, 1), v = determinant(0, 2), w = determinant(1, 0);
    if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) return;
    const double sum = u + v + w;
    const double t =
        (u * static_cast<double>(pz[0]) + v * static_cast<double>(pz[1]) + w * static_cast<double>(pz[2])) *
        static_cast<double>(scale_z) / sum;
    if (!(t >= t_near && t <= best.t) || (t == best.t && number >= best.triangle)) return;
    best = {number, v / sum, w / sum, t};
  }
};

}  // namespace concino::detail
