// Green coordinates of points in a cage of triangles: weights of its verts and of its normals.
#pragma once

#include <concino/deform/detail/cages/flat_cage.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Row i are the weights for point i. Those of normals are lengths.
struct green_rows {
  std::size_t num_verts = 0;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<vec3, 2>> spans;  // of each triangle, the vectors from its first corner
  std::vector<double> of_verts, of_normals;

  /// Errors: invalid_argument if there is another number of points.
  std::vector<vec3> points_of(const std::vector<vec3>& bent) const;
};

/// Errors: those of make_flat_cage; unsupported if a poly is no triangle; invalid_argument if a listed point is not
///         inside; invalid_mesh if a triangle has no area.
green_rows make_green_rows(const cage_polys& cage, const std::vector<vec3>& points,
                           const std::vector<std::size_t>& rows);

/// Errors: invalid_argument if the triangles of a bent cage are others.
void check_triangles(const green_rows& weights, const std::vector<std::array<std::uint32_t, 3>>& bent);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/cages/green.ipp>
#endif
