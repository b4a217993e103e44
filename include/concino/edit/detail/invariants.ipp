// Bodies of invariants.hpp: invariants that do not depend on the mesh: no inverted or degenerate poly, a minimum
// quality.
#pragma once

#include <concino/core/local_points.hpp>
#include <concino/edit/invariants.hpp>
#include <concino/geometry/orientation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace concino {

namespace detail {

inline double largest_coordinate(const vec3& u) { return std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z)}); }

/// The corners of a poly. If their products would overflow or underflow, they are scaled by a power of two, on which
/// neither signs nor qualities depend.
inline std::array<vec3, 4> points_of(const proposed_edit& e, std::span<const unsigned> poly,
                                     std::span<const vec3> points) {
  std::array<vec3, 4> p{};
  double largest = 0;
  for (unsigned i = 0; i < e.corners_per_poly; ++i) {
    p[i] = points[poly[i]];
    largest = std::max(largest, largest_coordinate(p[i]));
  }
  if (largest > 0x1p-200 && largest < 0x1p200) return p;
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double scale = std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
  for (vec3& x : p) x *= scale;
  return p;
}

/// A vector along the normal, of a length that neither overflows nor underflows; zero for one point.
inline vec3 scaled_normal(const std::array<vec3, 4>& p) {
  vec3 u = p[1] - p[0], v = p[2] - p[0];
  const double lu = largest_coordinate(u), lv = largest_coordinate(v);
  if (lu == 0 || lv == 0) return {};
  return cross(u /= lu, v /= lv);
}

}  // namespace detail

CONCINO_INLINE permission no_inversion_invariant::operator()(const proposed_edit& e) const {
  constexpr permission degenerate{refusal::invariant, "no_inversion: a new poly would be degenerate or inverted"};
  for (std::size_t k = 0; k < e.num_new_polys(); ++k) {
    const auto p = detail::points_of(e, e.new_poly(k), e.points_after);
    if (core::is_degenerate_simplex(std::span(p).first(e.corners_per_poly))) return degenerate;
    if (e.corners_per_poly == 4) {
      if (orient3d(p[0], p[1], p[2], p[3]) <= 0) return degenerate;
      continue;
    }
    const vec3 normal = detail::scaled_normal(p);
    for (unsigned i = e.origins[k].first; i < e.origins[k].first + e.origins[k].count; ++i) {
      const auto old = detail::points_of(e, e.old_poly(i), e.points_before);
      if (!core::is_degenerate_simplex(std::span(old).first(3)) && dot(normal, detail::scaled_normal(old)) <= 0)
        return degenerate;
    }
  }
  return {};
}

CONCINO_INLINE permission min_quality::operator()(const proposed_edit& e) const {
  for (std::size_t k = 0; k < e.num_new_polys(); ++k) {
    const auto p = detail::points_of(e, e.new_poly(k), e.points_after);
    const bool is_tet = e.corners_per_poly == 4;
    const double value =
        quality(is_tet ? poly_shape::tet : poly_shape::triangle, std::span(p).first(e.corners_per_poly), what);
    if (std::isnan(value) || is_worse(what, value, limit))
      return {refusal::invariant, "min_quality: a new poly would have less than the minimum quality"};
  }
  return {};
}

}  // namespace concino
