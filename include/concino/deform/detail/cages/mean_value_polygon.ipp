// Defines mean_value.hpp for polygons.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/deform/detail/cages/mean_value.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

/// Writes the weights of the corners for x, and returns the error of the linear functions, relative to the distances.
CONCINO_INLINE double mean_value_in_polygon(const std::vector<vec3>& polygon, double size, const vec3& x, double* w) {
  const std::size_t n = polygon.size();
  std::fill_n(w, n, 0.0);
  const auto seen = [&](std::size_t i) { return vec3{polygon[i].x - x.x, polygon[i].y - x.y, 0}; };
  double sum = 0;
  bool is_on_edge = false;
  for (std::size_t i = 0; i < n && !is_on_edge; ++i) {
    const std::size_t j = (i + 1) % n;
    const vec3 a = seen(i), b = seen(j);
    const double r = norm(a), s = norm(b), area = cross(a, b).z, scalar = dot(a, b), length = norm(b - a);
    if (r <= 1e-11 * size || s <= 1e-11 * size || (scalar < 0 && std::abs(area) <= 1e-11 * size * length)) {
      std::fill_n(w, n, 0.0);
      const double t = length > 0 ? std::clamp(dot(-a, b - a) / (length * length), 0.0, 1.0) : 0;
      w[i] += 1 - t;
      w[j] += t;
      is_on_edge = true;
    } else {
      // the tangent of half the angle, without cancellation for angles near 180 degrees
      const double tangent = scalar > 0 ? area / (r * s + scalar) : (r * s - scalar) / area;
      if (area == 0) continue;
      w[i] += tangent / r;
      w[j] += tangent / s;
    }
  }
  double far = size;
  vec3 error;
  for (std::size_t i = 0; i < n; ++i) sum += w[i];
  if (!(std::abs(sum) > 0)) return std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    w[i] /= sum;
    error += w[i] * seen(i);
    far = std::max(far, norm(seen(i)));
  }
  return norm(error) / far;
}

CONCINO_INLINE std::vector<double> mean_value_weights_of_polygon(const std::vector<vec3>& polygon,
                                                                 const std::vector<vec3>& points,
                                                                 const std::vector<std::size_t>& rows,
                                                                 const char* caller) {
  if (polygon.size() < 3)
    core::throw_joined<invalid_argument>(
        {caller, ": the polygon has ", polygon.size(), " corners; it needs 3 or more"});
  double largest = 0;
  for (const vec3& p : polygon)
    largest = std::max({largest, std::abs(p.x - polygon[0].x), std::abs(p.y - polygon[0].y)});
  if (!(largest > 1e-290 && largest < 1e290))
    core::throw_joined<invalid_argument>({caller, ": the corners of the polygon are all equal, or too far apart"});
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double unit = std::ldexp(1.0, exponent);
  std::vector<vec3> scaled = polygon;
  for (vec3& p : scaled) p /= unit;
  std::vector<double> all(points.size() * polygon.size()), errors(rows.size());
  parallel_for(rows.size(), [&](std::size_t i) {
    errors[i] =
        mean_value_in_polygon(scaled, largest / unit, points[rows[i]] / unit, all.data() + rows[i] * polygon.size());
  });
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!(errors[i] <= 1e-9))
      core::throw_joined<invalid_argument>({caller, ": point ", rows[i],
                                            " is too far from the polygon: its coordinates would not be accurate"});
  return all;
}

}  // namespace concino::detail
