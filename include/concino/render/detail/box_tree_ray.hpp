// A ray and the test of triangles that all queries of box_tree_tracer.hpp share.
#pragma once

#include <concino/render/box_tree_tracer.hpp>
#include <concino/render/detail/lanes.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace concino {

/// A ray in single precision, prepared for the tests of boxes and triangles.
struct box_tree_caster::ray {
  float origin[3];
  float near_origin[3], far_origin[3];  // moved so that rounding never makes a ray miss the box of a triangle that it hits
  float inverse[3];                     // 1 / direction
  std::size_t near_row[3];              // of bounds: the plane that the ray meets first
  std::size_t x, y, z;                  // the axes, so that the direction is longest along z
  float shear_x, shear_y, scale_z;      // these map the direction to (0, 0, 1)

  ray(const vec3& from, const vec3& direction, const std::array<float, 3>& low, const std::array<float, 3>& high) {
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

/// Tests the triangles of a block; updates the best hit.
inline void box_tree_caster::test(const block& triangles, const ray& r, double t_near, ray_hit& best) const {
  using detail::double4;
  using detail::float4;
  float4 x[3], y[3], z[3];
  for (std::size_t c = 0; c < 3; ++c) {
    z[c] = detail::load_lanes(triangles.corner[c][r.z]) - r.origin[r.z];
    x[c] = (detail::load_lanes(triangles.corner[c][r.x]) - r.origin[r.x]) - r.shear_x * z[c];
    y[c] = (detail::load_lanes(triangles.corner[c][r.y]) - r.origin[r.y]) - r.shear_y * z[c];
  }
  // Products of two floats are exact in double precision. So the signs are exact, and the triangles on both sides of an edge agree about it.
  const double4 ax(x[0]), ay(y[0]), bx(x[1]), by(y[1]), cx(x[2]), cy(y[2]);
  const double4 u = double4::determinant(cx, cy, bx, by), v = double4::determinant(ax, ay, cx, cy), w = double4::determinant(bx, by, ax, ay);
  const double4::truth same_sign = double4::have_same_sign(u, v, w);
  if (same_sign.none()) return;
  for (int k = 0; k < 4; ++k) {
    if (!same_sign[k]) continue;
    const double sum = u[k] + v[k] + w[k];
    const double t = (u[k] * z[0][k] + v[k] * z[1][k] + w[k] * z[2][k]) * r.scale_z / sum;
    if (!(t >= t_near && t <= best.t) || (t == best.t && triangles.triangle[k] >= best.triangle)) continue;
    best = {triangles.triangle[k], v[k] / sum, w[k] / sum, t};
  }
}

}  // namespace concino
