// The vectors along which verts move so that the planes of polys keep a distance.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/generate/detail/sweep/swept_surface.hpp>

#include <vector>

namespace concino::detail {

/// For each vert of a surface, the shortest vector whose products with the unit normals of the polys at it are as near
/// to 1 as possible, by least squares; 0 without polys.
std::vector<vec3> plane_offsets(const swept_surface& s, const std::vector<vec3>& poly_normals);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/sweep/plane_offsets.ipp>
#endif
