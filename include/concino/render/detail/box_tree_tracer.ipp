// The definitions of box_tree_tracer.hpp: the tree is built, and traversed by rays.
#pragma once

#include <concino/core/box_tree_builder.hpp>
#include <concino/core/error.hpp>
#include <concino/render/box_tree_tracer.hpp>
#include <concino/render/detail/lanes.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

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

/// Calls visit(block) for the leaves whose box the ray hits; near ones first, if ordered. It returns the largest parameter that is still of interest;
/// below t_near: none.
template<bool Ordered, class Visit>
void box_tree_caster::visit_leaves(const ray& r, float t_near, float t_far, Visit&& visit) const {
  using detail::float4;
  struct entry {
    std::uint32_t child;
    float t;
  };
  if (nodes_.empty()) return;
  constexpr float more = 1 + 6 * 0x1p-24f;  // for the rounding of the two parameters
  entry later[896];                         // seven for each level of a tree of 2^31 triangles
  std::size_t waiting = 0;
  std::uint32_t at = 0;
  const float4 ix = detail::lanes_of(r.inverse[0]), iy = detail::lanes_of(r.inverse[1]), iz = detail::lanes_of(r.inverse[2]);
  const float4 ax = detail::lanes_of(r.near_origin[0]), ay = detail::lanes_of(r.near_origin[1]), az = detail::lanes_of(r.near_origin[2]);
  const float4 bx = detail::lanes_of(r.far_origin[0]), by = detail::lanes_of(r.far_origin[1]), bz = detail::lanes_of(r.far_origin[2]);
  const std::size_t nx = r.near_row[0], ny = r.near_row[1], nz = r.near_row[2];
  while (true) {
    if (at & is_block) {
      t_far = visit(blocks_[at & ~is_block]);
      if (t_far < t_near) return;
    } else {
      const node& n = nodes_[at];
      float4 first[2];
      unsigned mask = 0;
      for (std::size_t h = 0; h < 2; ++h) {  // four children at once
        const std::size_t k = 4 * h;
        const float4 x0 = (detail::load_lanes(n.bounds[nx] + k) - ax) * ix, x1 = (detail::load_lanes(n.bounds[nx ^ 1] + k) - bx) * ix;
        const float4 y0 = (detail::load_lanes(n.bounds[ny] + k) - ay) * iy, y1 = (detail::load_lanes(n.bounds[ny ^ 1] + k) - by) * iy;
        const float4 z0 = (detail::load_lanes(n.bounds[nz] + k) - az) * iz, z1 = (detail::load_lanes(n.bounds[nz ^ 1] + k) - bz) * iz;
        first[h] = detail::larger_lanes(detail::larger_lanes(x0, y0), detail::larger_lanes(z0, detail::lanes_of(t_near)));
        const float4 last = detail::smaller_lanes(detail::smaller_lanes(detail::smaller_lanes(x1, y1), z1) * more, detail::lanes_of(t_far));
        mask |= detail::lane_mask(first[h] <= last) << k;
      }
      if constexpr (!Ordered) {
        for (; mask != 0; mask &= mask - 1) later[waiting++].child = n.child[std::countr_zero(mask)];
      } else {
        const std::size_t start = waiting;
        for (; mask != 0; mask &= mask - 1) {
          const int k = std::countr_zero(mask);
          const float t = first[k >> 2][k & 3];
          std::size_t i = waiting++;
          for (; i > start && later[i - 1].t < t; --i) later[i] = later[i - 1];
          later[i] = {n.child[k], t};
        }
      }
    }
    do {
      if (waiting == 0) return;
      --waiting;
    } while (Ordered && !(later[waiting].t <= t_far));
    at = later[waiting].child;
  }
}

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

CONCINO_INLINE ray_hit box_tree_caster::intersect(const vec3& origin, const vec3& direction, double t_near, double t_far) const {
  const ray r(origin, direction, low_, high_);
  ray_hit best;
  best.t = t_far;
  visit_leaves<true>(r, static_cast<float>(t_near), static_cast<float>(t_far), [&](const block& b) {
    test(b, r, t_near, best);
    return static_cast<float>(best.t);
  });
  return best ? best : ray_hit{};
}

CONCINO_INLINE bool box_tree_caster::occluded(const vec3& origin, const vec3& direction, double t_near, double t_far) const {
  const ray r(origin, direction, low_, high_);
  ray_hit best;
  best.t = t_far;
  visit_leaves<false>(r, static_cast<float>(t_near), static_cast<float>(t_far), [&](const block& b) {
    test(b, r, t_near, best);
    return best ? -std::numeric_limits<float>::infinity() : static_cast<float>(best.t);
  });
  return static_cast<bool>(best);
}

/// Groups the triangles, and joins the binary nodes to nodes of eight children.
struct box_tree_caster::builder {
  struct binary_node {
    float min[3], max[3];
    std::uint32_t first, count;

    float half_area() const {
      const float x = max[0] - min[0], y = max[1] - min[1], z = max[2] - min[2];
      return x * y + y * z + z * x;
    }
  };
  static constexpr float inf = std::numeric_limits<float>::infinity();

  const triangle_soup& soup;
  box_tree_caster& result;

  builder(const triangle_soup& triangles, box_tree_caster& tree) : soup(triangles), result(tree) {}

  std::vector<core::box_item> items;
  std::vector<binary_node> binary;
  std::vector<std::array<float, 8>> costs;
  std::array<std::uint32_t, 8> group{};
  std::uint32_t group_size = 0;

  void add_items() {
    core::reserve_large(items, soup.triangles.size());
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
      core::box_item item{{inf, inf, inf}, {-inf, -inf, -inf}, static_cast<std::uint32_t>(i)};
      bool finite = true;
      for (const std::uint32_t p : soup.triangles[i]) {
        if (p >= soup.points.size()) core::throw_joined<invalid_argument>({"box_tree_tracer: triangle ", i, " names point ", p, " of ", soup.points.size()});
        for (std::size_t k = 0; k < 3; ++k) {
          const float x = soup.points[p][k];
          finite = finite && std::isfinite(x);
          item.min[k] = std::min(item.min[k], x);
          item.max[k] = std::max(item.max[k], x);
        }
      }
      if (finite) items.push_back(item);
    }
  }

  void add_boxes() {
    for (std::size_t i = binary.size(); i-- > 0;) {
      binary_node& n = binary[i];
      std::fill_n(n.min, 3, inf);
      std::fill_n(n.max, 3, -inf);
      const auto add = [&](const float (&low)[3], const float (&high)[3]) {
        for (std::size_t k = 0; k < 3; ++k) n.min[k] = std::min(n.min[k], low[k]), n.max[k] = std::max(n.max[k], high[k]);
      };
      for (std::uint32_t k = n.first; k < n.first + n.count; ++k) add(items[k].min, items[k].max);
      if (n.count == 0)
        for (const std::uint32_t c : {n.first, n.first + 1}) add(binary[c].min, binary[c].max);
    }
  }

  std::uint32_t add_block(const binary_node& n) {
    block b;
    const float none = std::numeric_limits<float>::quiet_NaN();
    for (std::uint32_t k = 0; k < 4; ++k) {
      const bool used = k < n.count;
      b.triangle[k] = used ? items[n.first + k].id : ray_hit::none;
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t axis = 0; axis < 3; ++axis) b.corner[c][axis][k] = used ? soup.points[soup.triangles[b.triangle[k]][c]][axis] : none;
    }
    result.blocks_.push_back(b);
    return static_cast<std::uint32_t>(result.blocks_.size() - 1) | is_block;
  }

  /// How to divide j subtrees between the two children of an inner node for the least cost.
  struct division {
    std::uint32_t left = 1;
    float cost = inf;

    division(const builder& b, const binary_node& n, std::uint32_t j) {
      for (std::uint32_t k = 1; k < j; ++k)
        if (const float c = b.costs[n.first][k - 1] + b.costs[n.first + 1][j - k - 1]; c < cost) left = k, cost = c;
    }
  };

  /// costs[n][j - 1]: the expected cost of a query below binary node n, if at most j of its descendants, or n itself, are children of one node.
  /// Source: Ylitie, Karras and Laine 2017, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs".
  void add_costs() {
    costs.resize(binary.size());
    for (std::size_t i = binary.size(); i-- > 0;) {
      const binary_node& n = binary[i];
      costs[i].fill(n.half_area());
      if (n.count > 0) continue;
      costs[i][0] += division(*this, n, 8).cost;
      for (std::uint32_t j = 2; j <= 8; ++j) costs[i][j - 1] = std::min(costs[i][j - 2], division(*this, n, j).cost);
    }
  }

  /// The nodes that are at most j children of one node instead of binary node n.
  void add_children(std::uint32_t n, std::uint32_t j) {
    while (j > 1 && costs[n][j - 1] == costs[n][j - 2]) --j;
    if (j == 1 || binary[n].count > 0) {
      group[group_size++] = n;
      return;
    }
    const std::uint32_t left = division(*this, binary[n], j).left;
    add_children(binary[n].first, left);
    add_children(binary[n].first + 1, j - left);
  }

  /// The node of eight children for binary node `from`.
  void fill(std::uint32_t at, std::uint32_t from) {
    group_size = 0;
    if (binary[from].count > 0) {
      group[group_size++] = from;
    } else {
      const std::uint32_t left = division(*this, binary[from], 8).left;
      add_children(binary[from].first, left);
      add_children(binary[from].first + 1, 8 - left);
    }
    const std::uint32_t size = group_size;
    for (std::uint32_t k = 0; k < 8; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        result.nodes_[at].bounds[2 * axis][k] = k < size ? binary[group[k]].min[axis] : inf;
        result.nodes_[at].bounds[2 * axis + 1][k] = k < size ? binary[group[k]].max[axis] : -inf;
      }
      std::uint32_t child = 0;
      if (k < size && binary[group[k]].count > 0) child = add_block(binary[group[k]]);
      else if (k < size) {
        child = static_cast<std::uint32_t>(result.nodes_.size());
        result.nodes_.emplace_back();
        later.push_back({child, group[k]});
      }
      result.nodes_[at].child[k] = child;
    }
  }

  struct task {
    std::uint32_t node, from;
  };
  std::vector<task> later;

  void run() {
    if (soup.triangles.size() >= is_block) throw unsupported("box_tree_tracer: more than 2^31 triangles");
    add_items();
    if (items.empty()) return;
    binary = core::box_tree_builder<binary_node>(items, 4)();
    add_boxes();
    add_costs();
    std::copy_n(binary[0].min, 3, result.low_.begin());
    std::copy_n(binary[0].max, 3, result.high_.begin());
    std::size_t leaves = 0;
    for (const binary_node& n : binary) leaves += n.count > 0;
    result.blocks_.reserve(leaves);
    result.nodes_.reserve(leaves / 4 + 1);
    result.nodes_.emplace_back();
    later.push_back({0, 0});
    while (!later.empty()) {
      const task t = later.back();
      later.pop_back();
      fill(t.node, t.from);
    }
  }
};

CONCINO_INLINE box_tree_caster::box_tree_caster(const triangle_soup& soup) { builder(soup, *this).run(); }

}  // namespace concino
