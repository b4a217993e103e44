// Blending of transforms by weights, for points in an array.
#pragma once

#include <concino/deform/affine_map.hpp>
#include <concino/deform/skin_weights.hpp>

#include <cstddef>
#include <vector>

namespace concino::detail {

/// Errors: see skin.
void check_skin(const skin_weights& weights, std::size_t num_points, const std::vector<std::size_t>& used,
                const std::vector<affine_map>& transforms, bool rigid);

/// The images of the points whose indices are listed; others are the origin.
std::vector<vec3> blend_linearly(const std::vector<vec3>& points, const std::vector<std::size_t>& used,
                                 const skin_weights& weights, const std::vector<affine_map>& transforms);
std::vector<vec3> blend_dual_quaternions(const std::vector<vec3>& points, const std::vector<std::size_t>& used,
                                         const skin_weights& weights, const std::vector<affine_map>& transforms);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/skin/blend.ipp>
#endif
