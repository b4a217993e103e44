// Bodies of shape_size.hpp: what shapes of all kinds check: their size, and numbers that are given for each point.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/render/detail/shapes/shape_size.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

namespace concino::detail {

CONCINO_INLINE void check_shape_size(const char* caller, std::size_t corners) {
  if (corners >= std::numeric_limits<std::uint32_t>::max())
    core::throw_joined<unsupported>(
        {caller, ": ", corners,
         " corners of polygons; a drawable has at most 4,294,967,294: draw fewer or simpler shapes"});
}

CONCINO_INLINE double shape_radius(double radius, double part, std::span<const vec3> points) {
  if (radius > 0) return radius;
  box b;
  for (const vec3& p : points) b.add(p);
  const double diagonal = b.diagonal();
  return diagonal > 0 && std::isfinite(diagonal) ? part * diagonal : 1;
}

CONCINO_INLINE void check_radii(const char* caller, std::span<const double> radii) {
  for (std::size_t i = 0; i < radii.size(); ++i)
    if (!(radii[i] > 0 && std::isfinite(radii[i])))
      core::throw_joined<invalid_argument>(
          {caller, ": the radius of point ", i, " must be positive and finite, not ", core::number_text(radii[i])});
}

CONCINO_INLINE void check_shape_option(bool holds, const char* caller, const char* what, double number) {
  if (!holds) core::throw_joined<invalid_argument>({caller, ": ", what, ", not ", core::number_text(number)});
}

}  // namespace concino::detail
