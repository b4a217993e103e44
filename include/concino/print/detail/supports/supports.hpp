// The volume of straight supports below triangles, down to the surfaces below them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// A triangle as a function of a point of the plane, and its outline there, counter-clockwise.
struct height_triangle {
  std::array<vec3, 3> corners;
  double slope_x = 0, slope_y = 0;
  double low = 0, high = 0;
  double area_factor = 1;  // its area, as a multiple of that of its projection

  double at(double x, double y) const {
    const double z = corners[0].z + slope_x * (x - corners[0].x) + slope_y * (y - corners[0].y);
    return z < low ? low : z > high ? high : z;
  }
};

struct supports_size {
  double volume = 0;
  double contact_area = 0;  // of the triangles above and below with the supports, without the plate
};

/// The supports below a ceiling, above the highest of the candidates or the plate.
supports_size measure_supports(const height_triangle& ceiling, std::vector<const height_triangle*> candidates,
                               double plate, double tolerance);

/// The triangle as a function, if it is not vertical: 1 if it faces up, -1 down, else 0. What seems no wider than the
/// tolerance from above is vertical up to rounding.
int make_height_triangle(const std::array<vec3, 3>& corners, double tolerance, height_triangle& result);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/print/detail/supports/supports.ipp>
#endif
