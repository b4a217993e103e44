// Directions at any scale: if squares or products of coordinates overflow or underflow, the computation is repeated
// with points multiplied by a power of two, which is exact.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/geometry/polygon.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

/// Whether a sum of squares, or of products of squares, is accurate to all digits.
inline bool keeps_digits(double squared) { return squared > 1e-280 && squared < 1e290; }

inline double largest_component(const vec3& a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }

inline vec3 times_power_of_two(const vec3& a, int exponent) {
  return {std::ldexp(a.x, exponent), std::ldexp(a.y, exponent), std::ldexp(a.z, exponent)};
}

/// A multiple of a with a length of about 1; unchanged if a is 0 or not finite.
inline vec3 rescaled(const vec3& a) {
  const double size = largest_component(a);
  return size > 0 && std::isfinite(size) ? times_power_of_two(a, -std::ilogb(size)) : a;
}

/// A multiple of b - a that cannot overflow, for points of any size.
inline vec3 rescaled_step(const vec3& a, const vec3& b) {
  const vec3 step = b - a;
  return is_finite(step) ? rescaled(step) : rescaled(0.25 * b - 0.25 * a);
}

/// a scaled to length 1, or the result of `otherwise` if a is 0 or not accurate to all digits.
template<class F>
vec3 unit_or(const vec3& a, F&& otherwise) {
  const double squared = dot(a, a);
  if (keeps_digits(squared)) return a / std::sqrt(squared);
  return otherwise();
}

/// a scaled to length 1; 0 remains 0, and vectors that are not finite give NaN.
inline vec3 unit_vector(const vec3& a) {
  return unit_or(a, [&] {
    const vec3 b = rescaled(a);
    const double squared = dot(b, b);
    return squared == 0 ? vec3{} : b / std::sqrt(squared);
  });
}

/// Translates points and multiplies them by a power of two. One of them becomes the origin, and the farthest one is at
/// a distance of about 1.
class local_frame {
  vec3 base_;
  double shrink_ = 1;  // differences of the largest doubles overflow
  int exponent_ = 0;
  bool is_finite_ = true;

 public:
  /// for_each(visit) calls visit(x) for each point x.
  template<class ForEach>
  explicit local_frame(const ForEach& for_each) {
    double farthest = 0, size = 0;
    bool any = false;
    for_each([&](const vec3& x) {
      if (!any) base_ = x;
      any = true;
      is_finite_ &= concino::is_finite(x);
      farthest = std::max(farthest, largest_component(x));
    });
    if (farthest > 0x1p1020) shrink_ = 0.0625;
    for_each([&](const vec3& x) { size = std::max(size, largest_component(shrink_ * x - shrink_ * base_)); });
    if (size > 0 && std::isfinite(size)) exponent_ = -std::ilogb(size);
  }
  /// Whether all points are finite.
  bool is_finite() const { return is_finite_; }
  vec3 operator()(const vec3& x) const { return times_power_of_two(shrink_ * x - shrink_ * base_, exponent_); }
  vec3 from_local(const vec3& x) const { return (shrink_ * base_ + times_power_of_two(x, -exponent_)) / shrink_; }
  /// The original value of a length, area or volume, by its dimension; infinite if it is too large.
  double from_local(double size, int dimension) const {
    return std::ldexp(size, dimension * ((shrink_ < 1 ? 4 : 0) - exponent_));
  }
};

/// The frame of a polygon of m, or of all faces of a poly.
template<class M, class Loop>
local_frame frame_of_loop(const M& m, const Loop& loop) {
  return local_frame([&](auto&& visit) {
    for (const vert_t<M> v : loop) visit(to_vec3(point(m, v)));
  });
}
template<class M>
void for_each_point_of(const M& m, const poly_t<M>& p, auto&& visit) {
  if constexpr (SurfaceMesh<M>) {  // the points from which the measure is computed
    for (const vert_t<M> v : adj_p2v(m, p)) visit(to_vec3(point(m, v)));
  } else {
    for (const face_t<M> f : adj_p2f(m, p))
      for (const vert_t<M> v : adj_f2v(m, f)) visit(to_vec3(point(m, v)));
  }
}
template<class M>
local_frame frame_of_poly(const M& m, const poly_t<M>& p) {
  return local_frame([&](auto&& visit) { for_each_point_of(m, p, visit); });
}

/// The points of m in a frame, as a function of verts.
template<class M>
auto points_by_vert_in(const M& m, const local_frame& frame) {
  return [&](const vert_t<M>& v) { return frame(to_vec3(point(m, v))); };
}

/// The direction of a signed sum of vector areas, for polygons so small or large that the sum is not accurate.
/// for_each(visit) calls visit(loop, sign) for every polygon.
template<class M, class ForEach>
vec3 direction_of_areas_at_any_scale(const M& m, const ForEach& for_each) {
  double farthest = 0, size = 0;  // the largest distance from the origin; the size of the polygons
  for_each([&](const auto& loop, double) {
    for (const vert_t<M> v : loop) farthest = std::max(farthest, largest_component(to_vec3(point(m, v))));
  });
  const double shrink = farthest > 0x1p1020 ? 0.0625 : 1.0;  // differences of the largest doubles overflow
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
  for_each([&](const auto& loop, double) {
    for_each_corner(loop, [&](const vec3& x) { size = std::max(size, largest_component(x)); });
  });
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

/// The direction of a sum of vector areas; 0 if they cancel or there are none.
template<class M, class ForEach>
vec3 direction_of_areas(const M& m, const ForEach& for_each) {
  vec3 sum;
  for_each([&](const auto& loop, double sign) { sum += sign * area_vector_of(m, loop); });
  return unit_or(sum, [&] { return direction_of_areas_at_any_scale(m, for_each); });
}

}  // namespace concino::detail
