// What shapes of all kinds check: their size, and numbers that are given for each point.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <cstddef>
#include <span>

namespace concino::detail {

/// Throws unsupported if a drawable would get so many corners of polygons.
void check_shape_size(const char* caller, std::size_t corners);

/// The radius that an option says; if that is 0, a part of the diagonal of the bounding box of some points, or 1 if
/// they coincide.
double shape_radius(double radius, double part, std::span<const vec3> points);

/// Throws invalid_argument unless all radii are positive and finite.
void check_radii(const char* caller, std::span<const double> radii);

/// Throws invalid_argument with the text `what` and the number, if something does not hold.
void check_shape_option(bool holds, const char* caller, const char* what, double number);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/shapes/shape_size.ipp>
#endif
