// Principal curvatures of a quadratic polynomial that is fitted to points.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <span>

namespace concino {

/// The principal curvatures of a surface at a point, and the directions in which it has them.
struct principal_curvature {
  double k1 = 0, k2 = 0;  // k1 >= k2, in units of length^-1; positive where the surface bends away from its normal
  vec3 d1, d2;            // of length 1, perpendicular, in the tangent plane; d1, d2 and the normal are right-handed
};

namespace detail {

/// The curvatures at the origin of the surface z = g . x + x . H x / 2 that is nearest to points in the sense of least
/// squares. z is along the normal, of length 1. Where points leave H or g undetermined, the smallest are used.
principal_curvature fit_curvature(std::span<const vec3> points, const vec3& normal);

}  // namespace detail

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/directions/detail/curvature/fitted_curvature.ipp>
#endif
