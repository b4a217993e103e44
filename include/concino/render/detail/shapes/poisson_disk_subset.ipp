// Bodies of poisson_disk_subset.hpp: chooses some of many points so that they are evenly distributed.
#pragma once

#include <concino/core/hash_bytes.hpp>
#include <concino/core/index_table.hpp>
#include <concino/render/detail/shapes/poisson_disk_subset.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace concino::detail {

/// Points of which no two are nearer than a distance, in a grid of cells of this size.
class spaced_points {
  using cell = std::array<std::int64_t, 3>;

  std::span<const vec3> points_;
  vec3 low_;
  double distance_;
  core::index_table numbers_;  // of points, by their cells

  static std::uint32_t hash(const cell& c) {
    std::uint32_t h = 0;
    for (const std::int64_t x : c) h = core::index_table::hash(static_cast<std::uint64_t>(x), h);
    return h;
  }
  cell cell_of(const vec3& p) const {
    // at most 1e12: see poisson_disk_subset
    const auto at = [&](double x, double low) { return static_cast<std::int64_t>((x - low) / distance_); };
    return {at(p.x, low_.x), at(p.y, low_.y), at(p.z, low_.z)};
  }

 public:
  spaced_points(std::span<const vec3> points, const vec3& low, double distance)
      : points_(points), low_(low), distance_(distance) {}

  bool has_near(const vec3& p) const {
    const auto is_near = [&](std::uint32_t i) { return concino::distance(points_[i], p) < distance_; };
    const cell middle = cell_of(p);
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z)
          if (numbers_.find(hash({middle[0] + x, middle[1] + y, middle[2] + z}), is_near) != core::index_table::none)
            return true;
    return false;
  }
  void add(std::uint32_t point) { numbers_.add(hash(cell_of(points_[point])), point); }
};

/// The extent of points: their smallest coordinates, and the largest difference.
struct point_extent {
  vec3 low;
  double size = 0;

  explicit point_extent(std::span<const vec3> points) : low(points[0]) {
    vec3 high = low;
    for (const vec3& p : points)
      for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    for (std::size_t k = 0; k < 3; ++k) size = std::max(size, high[k] / 2 - low[k] / 2);  // halves do not overflow
    size *= 2;
  }
};

/// Every third bit of the result is one of 20 bits.
constexpr std::uint64_t with_gaps(std::uint64_t x) {
  x = (x | x << 32) & 0x1f00000000ffffu;
  x = (x | x << 16) & 0x1f0000ff0000ffu;
  x = (x | x << 8) & 0x100f00f00f00f00fu;
  x = (x | x << 4) & 0x10c30c30c30c30c3u;
  return (x | x << 2) & 0x1249249249249249u;
}

/// One point of each cell of the finest octree that has at most `count` cells with points.
CONCINO_INLINE std::vector<std::uint32_t> one_in_each_cell(std::span<const vec3> points, const point_extent& extent,
                                                           std::size_t count) {
  struct keyed {
    std::uint64_t key;
    std::uint32_t point;
  };
  std::vector<keyed> order(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto bits = [&](double x, double low) {
      return with_gaps(extent.size > 0 ? static_cast<std::uint64_t>(std::min(1.0, (x - low) / extent.size) * 0xfffff)
                                       : 0);
    };
    order[i] = {
        bits(points[i].x, extent.low.x) << 2 | bits(points[i].y, extent.low.y) << 1 | bits(points[i].z, extent.low.z),
        static_cast<std::uint32_t>(i)};
  }
  std::sort(order.begin(), order.end(),
            [](const keyed& a, const keyed& b) { return a.key != b.key ? a.key < b.key : a.point < b.point; });
  unsigned shift = 0;
  for (;; shift += 3) {
    std::size_t cells = 1;
    for (std::size_t i = 1; i < order.size(); ++i) cells += (order[i].key >> shift) != (order[i - 1].key >> shift);
    if (cells <= count) break;
  }
  std::vector<std::uint32_t> some;
  for (std::size_t i = 0; i < order.size();) {
    std::uint32_t chosen = order[i].point;
    const std::uint64_t cell = order[i].key >> shift;
    for (; i < order.size() && order[i].key >> shift == cell; ++i)
      if (core::scrambled(order[i].point) < core::scrambled(chosen)) chosen = order[i].point;
    some.push_back(chosen);
  }
  return some;
}

/// Points of `candidates`, in this order, that are not nearer to those before them than a distance. More than `count`
/// are not looked for.
CONCINO_INLINE std::vector<std::uint32_t> spaced_by(std::span<const vec3> points, const point_extent& extent,
                                                    std::span<const std::uint32_t> candidates, double distance,
                                                    std::size_t count) {
  spaced_points chosen(points, extent.low, distance);
  std::vector<std::uint32_t> list;
  for (const std::uint32_t i : candidates) {
    if (chosen.has_near(points[i])) continue;
    list.push_back(i);
    if (list.size() > count) break;
    chosen.add(i);
  }
  return list;
}

CONCINO_INLINE std::vector<std::uint32_t> poisson_disk_subset(std::span<const vec3> points, std::size_t count) {
  std::vector<std::uint32_t> candidates(points.size());
  std::iota(candidates.begin(), candidates.end(), std::uint32_t{0});
  if (points.size() <= count || points.empty()) return candidates;
  const point_extent extent(points);
  if (points.size() > 8 * count) candidates = one_in_each_cell(points, extent, 8 * std::max<std::size_t>(count, 1));
  std::sort(candidates.begin(), candidates.end(),
            [](std::uint32_t a, std::uint32_t b) { return core::scrambled(a) < core::scrambled(b); });
  std::vector<std::uint32_t> best(candidates.begin(),
                                  candidates.begin() + std::min<std::ptrdiff_t>(1, static_cast<std::ptrdiff_t>(count)));
  if (!(extent.size > 0)) return best;
  double low = 0, high = 2 * extent.size, distance = extent.size / std::sqrt(static_cast<double>(count + 1));
  for (int round = 0; round < 20 && best.size() < count - count / 10; ++round) {
    std::vector<std::uint32_t> list = spaced_by(points, extent, candidates, distance, count);
    if (list.size() > count) {
      low = distance;
    } else {
      high = distance;
      if (list.size() > best.size()) best.swap(list);
    }
    distance = low > 0 ? std::sqrt(low * high) : high / 2;
    if (!(distance > 1e-12 * extent.size)) break;
  }
  std::sort(best.begin(), best.end());
  return best;
}

CONCINO_INLINE double mean_distance(std::span<const vec3> points) {
  const std::size_t n = points.size(), tries = std::min<std::size_t>(n, 256);
  double sum = 0;
  std::size_t found = 0;
  for (std::size_t k = 0; k < tries; ++k) {
    const vec3& p = points[n * k / tries];
    double nearest = std::numeric_limits<double>::infinity();
    for (const vec3& q : points) {
      const double d = distance(p, q);
      if (d > 0 && d < nearest) nearest = d;
    }
    if (std::isfinite(nearest)) sum += nearest, ++found;
  }
  return found > 0 ? sum / static_cast<double>(found) : 0;
}

}  // namespace concino::detail
