// Straight-line distances through space from the nearest of several sources.
#pragma once

#include <concino/core/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

/// A source of distances: its position and its initial distance.
struct distance_source {
  vec3 position;
  double distance;
};

/// The minimum over all sources of the initial distance plus the straight-line distance, found with a k-d tree.
class euclidean_distance {
  std::vector<distance_source> sources_;  // the middle source of each range splits it
  std::vector<std::uint8_t> axis_;
  std::vector<double> min_distance_;  // the smallest initial distance in the range of each source

  double build(std::size_t first, std::size_t end) {
    if (first == end) return std::numeric_limits<double>::infinity();
    vec3 low = sources_[first].position, high = low;
    for (std::size_t i = first; i < end; ++i)
      for (const std::size_t k : {0u, 1u, 2u}) {
        low[k] = std::min(low[k], sources_[i].position[k]);
        high[k] = std::max(high[k], sources_[i].position[k]);
      }
    std::size_t axis = 0;
    for (const std::size_t k : {1u, 2u})
      if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
    const std::size_t middle = first + (end - first) / 2;
    const auto at = [&](std::size_t i) { return sources_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(end),
                     [&](const auto& a, const auto& b) { return a.position[axis] < b.position[axis]; });
    axis_[middle] = static_cast<std::uint8_t>(axis);
    return min_distance_[middle] = std::min({sources_[middle].distance, build(first, middle), build(middle + 1, end)});
  }

  void search(std::size_t first, std::size_t end, const vec3& x, double& best) const {
    if (first == end) return;
    const std::size_t middle = first + (end - first) / 2;
    if (!(min_distance_[middle] < best)) return;
    const distance_source& s = sources_[middle];
    best = std::min(best, s.distance + distance(x, s.position));
    const double beyond = x[axis_[middle]] - s.position[axis_[middle]];
    if (beyond < 0) search(first, middle, x, best);
    else search(middle + 1, end, x, best);
    if (!(min_distance_[middle] + std::abs(beyond) < best)) return;
    if (beyond < 0) search(middle + 1, end, x, best);
    else search(first, middle, x, best);
  }

 public:
  explicit euclidean_distance(std::vector<distance_source> sources)
      : sources_(std::move(sources)), axis_(sources_.size()), min_distance_(sources_.size()) {
    build(0, sources_.size());
  }
  double operator()(const vec3& x) const {
    double best = std::numeric_limits<double>::infinity();
    search(0, sources_.size(), x, best);
    return best;
  }
};

}  // namespace concino::detail
