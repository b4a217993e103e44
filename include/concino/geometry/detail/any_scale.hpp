// Directions at any scale: where squares or products of coordinates over- or underflow, the same is computed once more of points that were
// multiplied by a power of two, which changes no digit.
#pragma once

#include <concino/geometry/polygon.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

/// Whether a sum of squares, or of products of squares, has all its digits.
inline bool keeps_digits(double squared) { return squared > 1e-280 && squared < 1e290; }

inline double largest_component(const vec3& a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }

inline vec3 times_power_of_two(const vec3& a, int exponent) {
  return {std::ldexp(a.x, exponent), std::ldexp(a.y, exponent), std::ldexp(a.z, exponent)};
}

/// Of about the size 1, in the direction of a; 0 and vectors that are not finite as they are.
inline vec3 about_one(const vec3& a) {
  const double size = largest_component(a);
  return size > 0 && std::isfinite(size) ? times_power_of_two(a, -std::ilogb(size)) : a;
}

/// b - a, but that it cannot overflow, for points of any size.
inline vec3 step_about_one(const vec3& a, const vec3& b) {
  const vec3 step = b - a;
  return is_finite(step) ? about_one(step) : about_one(0.25 * b - 0.25 * a);
}

/// a at length 1, or what `otherwise` finds where a is 0 or has not all its digits.
template<class F>
vec3 unit_or(const vec3& a, F&& otherwise) {
  const double squared = dot(a, a);
  if (keeps_digits(squared)) [[likely]] return a / std::sqrt(squared);
  return otherwise();
}

/// a at length 1; 0 stays 0, and what is not finite becomes not a number.
inline vec3 unit_vector(const vec3& a) {
  return unit_or(a, [&] {
    const vec3 b = about_one(a);
    const double squared = dot(b, b);
    return squared == 0 ? vec3{} : b / std::sqrt(squared);
  });
}

/// The direction of a sum of vector areas, each with a sign, of polygons so small or large that these have no digits. for_each(visit) calls
/// visit(loop, sign) for every polygon.
template<class M, class ForEach>
[[gnu::noinline, gnu::cold]] vec3 direction_of_areas_at_any_scale(const M& m, const ForEach& for_each) {
  double farthest = 0, size = 0;  // of the origin; of the polygons
  for_each([&](const auto& loop, double) {
    for (const vert_t<M> v : loop) farthest = std::max(farthest, largest_component(to_vec3(point(m, v))));
  });
  const double shrink = farthest > 0x1p1020 ? 0.0625 : 1.0;  // differences of the largest doubles are none
  const auto for_each_corner = [&](const auto& loop, auto&& corner) {
    vec3 first;
    bool any = false;
    for (const vert_t<M> v : loop) {
      const vec3 x = shrink * to_vec3(point(m, v));
      if (!any) first = x;
      any = true;
      corner(x - first);
    }
  };
  for_each([&](const auto& loop, double) { for_each_corner(loop, [&](const vec3& x) { size = std::max(size, largest_component(x)); }); });
  const int exponent = size > 0 && std::isfinite(size) ? -std::ilogb(size) : 0;
  vec3 sum;
  for_each([&](const auto& loop, double sign) {
    vec3 doubled, previous;
    for_each_corner(loop, [&](const vec3& x) {
      const vec3 step = times_power_of_two(x, exponent);
      doubled += cross(previous, step);
      previous = step;
    });
    sum += sign * doubled;
  });
  return unit_vector(sum);
}

/// The direction of a sum of vector areas; 0 where they cancel or there are none.
template<class M, class ForEach>
vec3 direction_of_areas(const M& m, const ForEach& for_each) {
  vec3 sum;
  for_each([&](const auto& loop, double sign) { sum += sign * area_vector_of(m, loop); });
  return unit_or(sum, [&] { return direction_of_areas_at_any_scale(m, for_each); });
}

}  // namespace concino::detail
