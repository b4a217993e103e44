// Bodies of coincident_points.hpp: finds the points of two meshes that coincide.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/generate/detail/unite/coincident_points.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace concino::detail {

/// Points in cubic cells.
class point_cells {
  std::span<const vec3> points_;
  double tolerance_;
  vec3 low_{}, high_{};
  double size_ = 1;                      // of a cell, a quarter of it, as differences of large coordinates overflow
  using cell = std::array<std::int64_t, 3>;
  struct cell_hash {
    std::size_t operator()(const cell& c) const {
      std::uint64_t h = 0;
      for (const std::int64_t x : c) h = (h ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u, h ^= h >> 29;
      return static_cast<std::size_t>(h);
    }
  };
  std::unordered_map<cell, std::vector<std::uint32_t>, cell_hash> in_cell_;  // the points of each cell, ascending

  std::int64_t position(double x, double low) const {
    return static_cast<std::int64_t>(std::floor((0.25 * x - 0.25 * low) / size_));
  }

 public:
  point_cells(std::span<const vec3> points, double tolerance) : points_(points), tolerance_(tolerance) {
    bool is_first = true;
    for (const vec3& x : points) {
      if (!is_finite(x)) continue;
      for (const std::size_t k : {0u, 1u, 2u})
        low_[k] = is_first ? x[k] : std::min(low_[k], x[k]), high_[k] = is_first ? x[k] : std::max(high_[k], x[k]);
      is_first = false;
    }
    const vec3 extent = 0.25 * high_ - 0.25 * low_;
    size_ = std::max(tolerance, 0x1p-40 * std::max({extent.x, extent.y, extent.z}));
    if (!(size_ > 0)) size_ = 1;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!is_finite(points[i])) continue;
      cell at;
      for (const std::size_t k : {0u, 1u, 2u}) at[k] = position(points[i][k], low_[k]);
      in_cell_[at].push_back(static_cast<std::uint32_t>(i));
    }
  }

  std::uint32_t nearest(const vec3& x) const {
    cell first, last;
    const double around = tolerance_ * 1.0000001;  // more than the rounding errors
    for (const std::size_t k : {0u, 1u, 2u}) {
      if (!(x[k] >= low_[k] - around && x[k] <= high_[k] + around)) return ~0u;
      first[k] = position(std::max(x[k] - around, low_[k]), low_[k]),
      last[k] = position(std::min(x[k] + around, high_[k]), low_[k]);
    }
    std::uint32_t found = ~0u;
    double least = tolerance_;
    cell at;
    for (at[0] = first[0]; at[0] <= last[0]; ++at[0])
      for (at[1] = first[1]; at[1] <= last[1]; ++at[1])
        for (at[2] = first[2]; at[2] <= last[2]; ++at[2]) {
          const auto here = in_cell_.find(at);
          if (here == in_cell_.end()) continue;
          for (const std::uint32_t i : here->second) {
            const double far = distance(points_[i], x);
            if (!(far <= least) || (found != ~0u && far == least && i > found)) continue;
            found = i, least = far;
          }
        }
    return found;
  }
};

CONCINO_INLINE std::vector<std::uint32_t> coincident_points(std::span<const vec3> among, std::span<const vec3> points,
                                                            double tolerance) {
  std::vector<std::uint32_t> found(points.size(), ~0u);
  if (among.empty()) return found;
  const point_cells cells(among, tolerance);
  parallel_for(points.size(), [&](std::size_t i) { found[i] = cells.nearest(points[i]); });
  return found;
}

}  // namespace concino::detail
