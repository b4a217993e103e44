// The centre of the circle through three points or of the sphere through four.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <span>

namespace concino::detail {

/// Of three or four points. Not finite if they lie on one line or in one plane.
vec3 centre_of_circumsphere(std::span<const vec3> points);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/geometry/detail/circles/circumsphere.ipp>
#endif
