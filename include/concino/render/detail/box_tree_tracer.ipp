// The first triangle of box_tree_tracer.hpp that a ray hits.
#pragma once

#include <concino/render/box_tree_tracer.hpp>
#include <concino/render/detail/box_tree_ray.hpp>
#include <concino/render/detail/lanes.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace concino {

/// Tests the triangles of a block; updates the best hit.
CONCINO_INLINE void box_tree_caster::test(const block& triangles, const detail::box_tree_ray& r, double t_near, ray_hit& best) const {
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

CONCINO_INLINE ray_hit box_tree_caster::intersect(const vec3& origin, const vec3& direction, double t_near, double t_far) const {
  using detail::float4;
  struct entry {
    std::uint32_t child;
    float t;
  };
  ray_hit best;
  if (nodes_.empty()) return best;
  const detail::box_tree_ray r(origin, direction, low_, high_);
  best.t = t_far;
  constexpr float more = 1 + 6 * 0x1p-24f;  // for the rounding of the two parameters
  const float near = static_cast<float>(t_near);
  float far = static_cast<float>(t_far);
  entry later[896];  // seven for each level of a tree of 2^31 triangles; the nearest last
  std::size_t waiting = 0;
  later[waiting++] = {0, near};
  const float4 ix = detail::lanes_of(r.inverse[0]), iy = detail::lanes_of(r.inverse[1]), iz = detail::lanes_of(r.inverse[2]);
  const float4 ax = detail::lanes_of(r.near_origin[0]), ay = detail::lanes_of(r.near_origin[1]), az = detail::lanes_of(r.near_origin[2]);
  const float4 bx = detail::lanes_of(r.far_origin[0]), by = detail::lanes_of(r.far_origin[1]), bz = detail::lanes_of(r.far_origin[2]);
  const std::size_t nx = r.near_row[0], ny = r.near_row[1], nz = r.near_row[2];
  while (waiting > 0) {
    const entry e = later[--waiting];
    if (!(e.t <= far)) continue;
    if (e.child & is_block) {
      test(blocks_[e.child & ~is_block], r, t_near, best);
      far = static_cast<float>(best.t);
      if (far < near) break;
      continue;
    }
    const node& n = nodes_[e.child];
    float4 first[2];
    unsigned mask = 0;
    for (std::size_t h = 0; h < 2; ++h) {  // four children at once
      const std::size_t k = 4 * h;
      const float4 x0 = (detail::load_lanes(n.bounds[nx] + k) - ax) * ix, x1 = (detail::load_lanes(n.bounds[nx ^ 1] + k) - bx) * ix;
      const float4 y0 = (detail::load_lanes(n.bounds[ny] + k) - ay) * iy, y1 = (detail::load_lanes(n.bounds[ny ^ 1] + k) - by) * iy;
      const float4 z0 = (detail::load_lanes(n.bounds[nz] + k) - az) * iz, z1 = (detail::load_lanes(n.bounds[nz ^ 1] + k) - bz) * iz;
      first[h] = detail::larger_lanes(detail::larger_lanes(x0, y0), detail::larger_lanes(z0, detail::lanes_of(near)));
      const float4 last = detail::smaller_lanes(detail::smaller_lanes(detail::smaller_lanes(x1, y1), z1) * more, detail::lanes_of(far));
      mask |= detail::lane_mask(first[h] <= last) << k;
    }
    for (const std::size_t start = waiting; mask != 0; mask &= mask - 1) {
      const int k = std::countr_zero(mask);
      const float t = first[k >> 2][k & 3];
      std::size_t i = waiting++;
      for (; i > start && later[i - 1].t < t; --i) later[i] = later[i - 1];
      later[i] = {n.child[k], t};
    }
  }
  return best ? best : ray_hit{};
}

}  // namespace concino
