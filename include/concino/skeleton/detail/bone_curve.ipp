// Defines bone_curve.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/skeleton/bone_curve.hpp>

namespace concino {

CONCINO_INLINE double length(const bone_curve& curve) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) sum += distance(curve.points[i], curve.points[i + 1]);
  return sum;
}

CONCINO_INLINE bone_sample sample(const bone_curve& curve, double fraction) {
  const std::size_t n = curve.points.size();
  if (n == 0) core::throw_joined<invalid_argument>({"sample: the curve has no points"});
  if (!curve.radii.empty() && curve.radii.size() != n)
    core::throw_joined<invalid_argument>({"sample: ", curve.radii.size(), " radii for ", n, " points"});
  if (!(fraction >= 0 && fraction <= 1))
    core::throw_joined<invalid_argument>({"sample: the fraction has to be from 0 to 1, as a part of the length"});
  const auto radius = [&](std::size_t i) { return curve.radii.empty() ? 0 : curve.radii[i]; };
  const double whole = length(curve), wanted = fraction * whole;
  if (n == 1 || !(whole > 0)) return {curve.points[0], radius(0), {}, 0, 0};
  double before = 0;
  std::size_t segment = 0, last = 0;
  for (std::size_t i = 0; i + 1 < n; ++i)
    if (!(curve.points[i] == curve.points[i + 1])) last = i;
  for (; segment < last; ++segment) {
    const double step = distance(curve.points[segment], curve.points[segment + 1]);
    if (step > 0 && before + step > wanted) break;
    before += step;
  }
  const vec3 &a = curve.points[segment], &b = curve.points[segment + 1];
  const double step = distance(a, b), t = fraction == 1 ? 1 : std::fmin(1, std::fmax(0, (wanted - before) / step));
  return {(1 - t) * a + t * b, (1 - t) * radius(segment) + t * radius(segment + 1), (b - a) / step, segment, t};
}

}  // namespace concino
