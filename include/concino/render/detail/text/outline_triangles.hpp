// Triangles of plane outlines with holes.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace concino::detail {

/// Counter-clockwise triangles that cover outlines, which lie in the plane of x and y. Counter-clockwise outlines are
/// filled. A clockwise one is a hole of the smallest filled outline around it. Outlines that overlap have overlapping
/// triangles. Source: holes are joined to outlines by bridges, Eberly 1998, and the polygons triangulated by ears.
std::vector<std::array<vec3, 3>> outline_triangles(std::span<const std::vector<vec3>> outlines);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/text/outline_triangles.ipp>
#endif
