// Mean value coordinates: the weights of the corners of a polygon at a point in it. They interpolate a field over a
// polygon smoothly, independent of its triangulation.
#pragma once

#include <concino/core/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace concino {

/// The weights of the corners of a polygon at point x.
/// Needs:  `normal`, the unit normal of the polygon; x and the corners are projected along it.
/// Result: weights[i] of corner i, with sum 1, exact for linear functions on planar polygons. At a corner, or on an
///         edge, only the corner itself, or the two ends of the edge, have a weight. Equal weights if the polygon has
///         no area.
/// Cost:   O(corners).      Errors: none.
/// Source: Hormann and Floater 2006, which also covers concave polygons.
inline void polygon_weights(std::span<const vec3> corners, const vec3& normal, const vec3& x,
                            std::vector<double>& weights) {
  const std::size_t n = corners.size();
  weights.assign(n, 0);
  const auto flat = [&](const vec3& p) {
    const vec3 d = p - x;
    return d - normal * dot(d, normal);
  };
  // tangent of half the angle from a to b at x
  const auto half_tangent = [&](const vec3& a, const vec3& b, double ra, double rb) {
    const double area = dot(normal, cross(a, b)), along = dot(a, b);
    return area != 0 ? (ra * rb - along) / area : 0;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = i + 1 < n ? i + 1 : 0;
    const vec3 a = flat(corners[i]), b = flat(corners[j]);
    const double ra = norm(a), rb = norm(b);
    if (ra == 0) {
      weights.assign(n, 0);
      weights[i] = 1;
      return;
    }
    // x is on the edge: its two ends are in opposite directions, up to rounding.
    if (std::abs(dot(normal, cross(a, b))) <= 1e-12 * ra * rb && dot(a, b) < 0) {
      weights.assign(n, 0);
      weights[i] = rb / (ra + rb);
      weights[j] = ra / (ra + rb);
      return;
    }
    if (rb == 0) continue;  // the next iteration handles it
    const double t = half_tangent(a, b, ra, rb);
    weights[i] += t / ra;
    weights[j] += t / rb;
  }
  double sum = 0;
  for (const double w : weights) sum += w;
  const bool usable = std::isfinite(sum) && sum != 0;
  for (double& w : weights) w = usable ? w / sum : 1 / static_cast<double>(n);
}

}  // namespace concino
