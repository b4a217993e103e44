// The points of one element, translated and scaled so that nothing overflows or underflows, and their accuracy. Which
// triangles and tets are degenerate.
#pragma once

#include <concino/core/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace concino::core {

/// After fit(points), these are relative to the first of them, in units of `unit`, with the largest coordinate in [0.5,
/// 1). Scaling is by powers of two, so sizes are equally accurate for any size of the mesh.
struct local_accuracy {
  vec3 box;         // extent of their bounding box, in units
  vec3 error;       // maximal effect of the rounding of coordinates on a point, in each direction, in units
  double size = 0;  // diagonal of the box, in units

  /// False if some point is not finite, or all are equal.
  bool fit(std::span<vec3> points) {
    double most = 0;
    for (const vec3& p : points) {
      if (!is_finite(p)) return false;
      most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    vec3 far;
    const double first_scale = to_one(most);
    for (vec3& p : points) {
      p *= first_scale;
      far = {std::max(far.x, std::abs(p.x)), std::max(far.y, std::abs(p.y)), std::max(far.z, std::abs(p.z))};
    }
    vec3 low, high;
    const vec3 origin = points.empty() ? vec3() : points.front();
    most = 0;
    for (vec3& p : points) {
      p -= origin;
      most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    if (!(most > 0)) return false;
    const double scale = to_one(most);
    for (vec3& p : points) {
      p *= scale;
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    box = high - low;
    size = norm(box);
    error = std::numeric_limits<double>::epsilon() * (scale * far + box);
    return true;
  }

  /// Whether an area vector of n corners is zero within the accuracy of their coordinates.
  bool is_zero_area(const vec3& a, std::size_t n) const {
    const double k = 2 * static_cast<double>(n);
    return std::abs(a.x) <= k * (box.y * error.z + box.z * error.y) &&
           std::abs(a.y) <= k * (box.x * error.z + box.z * error.x) &&
           std::abs(a.z) <= k * (box.x * error.y + box.y * error.x);
  }
  /// The largest volume of n corners that is zero within the accuracy of their coordinates.
  double zero_volume(std::size_t n) const {
    return 2 * static_cast<double>(n) * (box.y * box.z * error.x + box.x * box.z * error.y + box.x * box.y * error.z);
  }

 private:
  static double to_one(double x) {  // the power of two that scales x into [0.5, 1), or the nearest possible one
    int e = 0;
    std::frexp(x, &e);
    return std::ldexp(1.0, -std::max(e, -1000));
  }
};

struct local_points : local_accuracy {
  std::vector<vec3> points;

  /// False if some point is not finite, or all are equal.
  bool fit() { return local_accuracy::fit(points); }
};

/// Half the sum of cross products along the polygon points[first] .. points[last - 1], relative to the first of them.
inline vec3 vector_area(std::span<const vec3> points, std::size_t first, std::size_t last) {
  vec3 doubled;
  for (std::size_t i = first + 2; i < last; ++i)
    doubled += cross(points[i - 1] - points[first], points[i] - points[first]);
  return 0.5 * doubled;
}

/// Whether three corners make a triangle without area, or four a tet without volume, within the accuracy of their
/// coordinates. The order of the corners has no effect.
inline bool is_degenerate_simplex(std::span<const vec3> corners) {
  vec3 points[4];
  const std::size_t n = corners.size();
  std::copy_n(corners.begin(), n, points);
  const auto is_less = [](const vec3& a, const vec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  };
  for (std::size_t i = 1; i < n; ++i)
    for (std::size_t k = i; k > 0 && is_less(points[k], points[k - 1]); --k) std::swap(points[k], points[k - 1]);
  local_accuracy local;
  if (!local.fit({points, n})) return true;
  if (n == 3) return local.is_zero_area(vector_area({points, n}, 0, n), n);
  // as many as the corners of its faces
  return std::abs(dot(points[1], cross(points[2], points[3]))) <= 6 * local.zero_volume(12);
}

}  // namespace concino::core
