// Finds the cells between a surface and its offset that are inverted at a corner.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/generate/detail/sweep/swept_surface.hpp>

#include <vector>

namespace concino::detail {

/// The polys of a shell of which the three edges at a corner do not have the orientation of the corner of the surface:
/// with the edge along the normal of its vert, times the sign of the thickness, as third; or of which an edge has
/// turned by 90 degrees or more. Corners of the surface with a straight angle are not checked.
std::vector<poly_id> folded_cells(const swept_surface& s, const std::vector<vec3>& normals, double thickness,
                                  std::size_t num_layers);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/sweep/folded_cells.ipp>
#endif
