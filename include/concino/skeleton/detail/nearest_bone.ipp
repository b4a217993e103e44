// Defines nearest_bone.hpp.
#pragma once

#include <concino/skeleton/nearest_bone.hpp>

namespace concino::detail {

CONCINO_INLINE std::size_t nearest_curve(const std::vector<const bone_curve*>& curves, const vec3& x) {
  double smallest = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto& points = curves[i]->points;
    const auto consider = [&](const vec3& y) {
      if (const double d = distance(x, y); d < smallest) smallest = d, nearest = i;
    };
    consider(points[0]);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const segment s{points[k], points[k + 1]};
      consider(point_at(s, closest_parameter(s, x)));
    }
  }
  return nearest;
}

}  // namespace concino::detail
