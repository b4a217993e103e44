// Which rays of one origin the triangles of box_tree_tracer.hpp occlude: the tree is traversed once for up to 64 of them.
#pragma once

#include <concino/render/box_tree_tracer.hpp>
#include <concino/render/detail/box_tree_ray.hpp>
#include <concino/render/detail/lanes.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace concino {

/// Rays of one origin. Sets of them are bits.
/// What depends on a box or a triangle and the origin only is computed once for all rays that meet it. Many do, as most boxes that a ray from a surface
/// visits lie around its origin.
struct box_tree_caster::packet {
  struct prepared_ray {
    float inverse[3];           // 1 / direction
    float direction[3];         // scaled so that the largest coordinate is 1
    std::uint32_t near_row[3];  // of the bounds of a node: the plane that the ray meets first
  };

  const box_tree_caster& tree;
  const vec3& from;
  std::span<const vec3> directions;
  double t_near, t_far;
  float origin[3], row_origin[6];  // the second: moved so that rounding never makes a ray miss the box of a triangle that it hits
  prepared_ray rays[64];

  packet(const box_tree_caster& t, const vec3& o, std::span<const vec3> ds, double near, double far)
      : tree(t), from(o), directions(ds), t_near(near), t_far(far) {
    float extent[3], largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      origin[k] = static_cast<float>(o[k]);
      extent[k] = std::max(std::abs(t.low_[k] - origin[k]), std::abs(t.high_[k] - origin[k]));
      largest = std::max(largest, extent[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const float pad = 6 * 0x1p-24f * (extent[k] + largest);
      row_origin[2 * k] = origin[k] + pad;
      row_origin[2 * k + 1] = origin[k] - pad;
    }
    for (std::size_t i = 0; i < ds.size(); ++i) rays[i] = prepared(ds[i]);
  }

  static prepared_ray prepared(const vec3& direction) {
    prepared_ray r;
    float d[3], longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      d[k] = static_cast<float>(direction[k]);
      longest = std::max(longest, std::abs(d[k]));
    }
    const float scale = 1 / longest, least = 1e-18f * longest;  // so that no product below is 0 times infinity
    for (std::size_t k = 0; k < 3; ++k) {
      const bool negative = std::signbit(d[k]);
      r.direction[k] = d[k] * scale;
      r.near_row[k] = static_cast<std::uint32_t>(2 * k + negative);
      if (!(std::abs(d[k]) > least)) d[k] = negative ? -least : least;
      r.inverse[k] = 1 / d[k];
    }
    return r;
  }

  /// Calls visit(ray, its bit) for 32 rays from number `first`.
  template<class Visit>
  void for_each_ray(std::uint64_t active, std::size_t first, Visit&& visit) const {
    for (auto left = static_cast<std::uint32_t>(active >> first); left != 0; left &= left - 1)
      visit(rays[first + static_cast<std::size_t>(std::countr_zero(left))], static_cast<std::int32_t>(left & (~left + 1)));
  }

  /// For each child of a node, the rays that hit its box.
  std::array<std::uint64_t, 8> in_children(const node& n, std::uint64_t active) const {
    using detail::float4;
    using detail::int4;
    constexpr float more = 1 + 6 * 0x1p-24f;  // for the rounding of the two parameters
    const float4 near = detail::lanes_of(static_cast<float>(t_near)), far = detail::lanes_of(static_cast<float>(t_far));
    float4 bounds[6][2];  // four children at once
    for (std::size_t row = 0; row < 6; ++row)
      for (std::size_t h = 0; h < 2; ++h) bounds[row][h] = detail::load_lanes(n.bounds[row] + 4 * h) - row_origin[row];
    std::array<std::uint64_t, 8> result{};
    for (const std::size_t first_ray : {0u, 32u}) {
      int4 found[2] = {};
      for_each_ray(active, first_ray, [&](const prepared_ray& r, std::int32_t bit) {
        const float4 *const x = bounds[r.near_row[0]], *const y = bounds[r.near_row[1]], *const z = bounds[r.near_row[2]];
        const float4 *const x1 = bounds[r.near_row[0] ^ 1], *const y1 = bounds[r.near_row[1] ^ 1], *const z1 = bounds[r.near_row[2] ^ 1];
        const float ix = r.inverse[0], iy = r.inverse[1], iz = r.inverse[2];
        for (std::size_t h = 0; h < 2; ++h) {
          const float4 first = detail::larger_lanes(detail::larger_lanes(x[h] * ix, y[h] * iy), detail::larger_lanes(z[h] * iz, near));
          const float4 last = detail::smaller_lanes(detail::smaller_lanes(detail::smaller_lanes(x1[h] * ix, y1[h] * iy), z1[h] * iz) * more, far);
          found[h] |= (first <= last) & bit;
        }
      });
      for (std::size_t k = 0; k < 8; ++k) result[k] |= std::uint64_t{static_cast<std::uint32_t>(found[k >> 2][k & 3])} << first_ray;
    }
    return result;
  }

  /// The rays that may hit a triangle of a block: none that hits one is missed, and few others are among them.
  /// With p, q, r the corners from the origin, the ray d passes inside the edge from p to q if d (p x q) has the sign that it has for the other edges; the
  /// parameter is positive if r (p x q) has that sign, too. From what test() computes they differ by less than 80 and 160 * 2^-24 times the square and the cube
  /// of the largest coordinate.
  std::uint64_t candidates(const block& b, std::uint64_t active) const {
    using detail::float4;
    using detail::int4;
    float4 p[3][3], edge[3][3], size{};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 3; ++k) {
        p[c][k] = detail::load_lanes(b.corner[c][k]) - origin[k];
        size = detail::larger_lanes(size, detail::larger_lanes(p[c][k], -p[c][k]));
      }
    for (std::size_t c = 0; c < 3; ++c) {
      const float4 *const q = p[(c + 1) % 3], *const r = p[(c + 2) % 3];
      for (std::size_t k = 0, i = 1, j = 2; k < 3; i = j, j = k++) edge[c][k] = q[i] * r[j] - q[j] * r[i];
    }
    const float4 slack = size * size * (128 * 0x1p-24f) + 1e-36f, volume_slack = 4 * slack;
    const float4 scale = 1 / size;  // of the volume, so that it is finite
    const float4 volume = p[0][0] * scale * edge[0][0] + p[0][1] * scale * edge[0][1] + p[0][2] * scale * edge[0][2];
    const float4 none = detail::lanes_of(t_near >= 0 ? std::numeric_limits<float>::infinity() : 0);
    const float4 lowest = volume < -volume_slack ? none - slack : -slack, highest = volume > volume_slack ? slack - none : slack;
    std::uint64_t result = 0;
    for (const std::size_t first_ray : {0u, 32u}) {
      int4 found = {};
      for_each_ray(active, first_ray, [&](const prepared_ray& r, std::int32_t bit) {
        const float x = r.direction[0], y = r.direction[1], z = r.direction[2];
        const float4 u = edge[0][0] * x + edge[0][1] * y + edge[0][2] * z, v = edge[1][0] * x + edge[1][1] * y + edge[1][2] * z,
                     w = edge[2][0] * x + edge[2][1] * y + edge[2][2] * z;
        const float4 least = detail::smaller_lanes(detail::smaller_lanes(u, v), w), most = detail::larger_lanes(detail::larger_lanes(u, v), w);
        found |= ((least >= lowest) | (most <= highest)) & bit;
      });
      result |= std::uint64_t{static_cast<std::uint32_t>(found[0] | found[1] | found[2] | found[3])} << first_ray;
    }
    return result;
  }

  /// The rays that hit a triangle of a block.
  std::uint64_t in_block(const block& b, std::uint64_t active) const {
    std::uint64_t result = 0;
    for (std::uint64_t left = candidates(b, active); left != 0; left &= left - 1) {
      ray_hit best;
      best.t = t_far;
      const vec3& d = directions[static_cast<std::size_t>(std::countr_zero(left))];
      tree.test(b, detail::box_tree_ray(from, d, tree.low_, tree.high_), t_near, best);
      if (best) result |= left & (~left + 1);
    }
    return result;
  }

  /// The rays that hit a triangle.
  std::uint64_t occluded() const {
    struct entry {
      std::uint32_t child;
      std::uint64_t rays;
    };
    const std::uint64_t all = ~std::uint64_t{0} >> (64 - directions.size());
    entry later[896];  // seven for each level of a tree of 2^31 triangles
    std::size_t waiting = 0;
    later[waiting++] = {0, all};
    std::uint64_t result = 0;
    while (waiting > 0 && result != all) {
      const entry e = later[--waiting];
      const std::uint64_t active = e.rays & ~result;
      if (active == 0) continue;
      if (e.child & is_block) {
        result |= in_block(tree.blocks_[e.child & ~is_block], active);
        continue;
      }
      const node& n = tree.nodes_[e.child];
      const std::array<std::uint64_t, 8> hit = in_children(n, active);
      for (std::size_t k = 0; k < 8; ++k)
        if (hit[k] != 0) {
          tree.prefetch(n.child[k]);
          later[waiting++] = {n.child[k], hit[k]};
        }
    }
    return result;
  }
};

CONCINO_INLINE std::uint64_t box_tree_caster::occluded_rays(const vec3& origin, std::span<const vec3> directions, double t_near, double t_far) const {
  if (nodes_.empty() || directions.empty()) return 0;
  return packet(*this, origin, directions, t_near, t_far).occluded();
}

CONCINO_INLINE bool box_tree_caster::occluded(const vec3& origin, const vec3& direction, double t_near, double t_far) const {
  return occluded_rays(origin, {&direction, 1}, t_near, t_far) != 0;
}

}  // namespace concino
