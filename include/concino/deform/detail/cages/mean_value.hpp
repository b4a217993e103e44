// Mean value coordinates in cages of triangles and in polygons.
#pragma once

#include <concino/deform/detail/cages/flat_cage.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace concino::detail {

/// The weights of the verts of the cage for each point, in rows of cage.num_verts; 0 in rows that are not listed.
/// Errors: invalid_argument if a listed point is so far away that the weights would not reproduce it to 1e-9.
std::vector<double> mean_value_weights(const flat_cage& cage, const std::vector<vec3>& points,
                                       const std::vector<std::size_t>& rows, const char* caller);

/// The same for a polygon in the plane of x and y, whose corners are the verts.
/// Errors: also invalid_argument if it has less than 3 corners, or all are equal.
std::vector<double> mean_value_weights_of_polygon(const std::vector<vec3>& polygon, const std::vector<vec3>& points,
                                                  const std::vector<std::size_t>& rows, const char* caller);

/// The weights of the verts of a cage for a point on it, nearest to x: those of the triangle that it lies on.
/// weights has cage.num_points() entries. The result is the distance from x to the cage, in units.
double weights_on_cage(const flat_cage& cage, const vec3& x, std::vector<double>& weights);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/cages/mean_value.ipp>
#include <concino/deform/detail/cages/mean_value_polygon.ipp>
#endif
