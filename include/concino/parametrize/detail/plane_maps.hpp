// Maps of disks to the plane by linear systems, from flat arrays: conformal ones, and what all maps share.
#pragma once

#include <concino/core/progress.hpp>
#include <concino/parametrize/detail/poly_triangles.hpp>

#include <Eigen/SparseCore>

#include <utility>
#include <vector>

namespace concino::detail {

using plane_points = std::vector<uv_point>;
using fixed_points = std::vector<std::pair<std::uint32_t, uv_point>>;

/// The position of each vert of a disk among the unknowns; negative where it is fixed.
struct plane_unknowns {
  std::vector<int> number;
  int count = 0;

  plane_unknowns(std::size_t num_verts, const fixed_points& fixed);
};

/// The quadratic form of the integrated squared gradient of a function, divided by 2, with all entries.
void add_gradient_terms(const flat_disk& f, const poly_triangles& cut, int row, int column,
                        std::vector<Eigen::Triplet<double>>& entries);

/// Two verts of the boundary that are far from each other: the second is farthest from the centre, the first from it.
std::pair<std::uint32_t, std::uint32_t> far_pair(const flat_disk& f);

/// The signed area within the boundary.
double area_of_loop(const flat_disk& f, const plane_points& uv);

/// Moves the first vert of far_pair to the origin, and turns the second to the positive side of the x axis.
void place_upright(const flat_disk& f, plane_points& uv);

/// Scales a map to the area of the surface, if its area is positive.
void scale_to_area(const flat_disk& f, const poly_triangles& cut, plane_points& uv);

/// Points times a power of 2: to units of the mesh, and from them.
uv_point scaled_point(const uv_point& x, int exponent);
void scale_by(plane_points& uv, int exponent);

/// The least squares conformal map with these fixed points, two or more; without any, far_pair is fixed, and the map is
/// scaled to the area of the surface.
plane_points conformal_map(const flat_disk& f, const poly_triangles& cut, const fixed_points& fixed,
                                     const char* caller);

/// The conformal map that is smallest for its boundary.      Errors: solver_error.
plane_points smallest_conformal_mode(const flat_disk& f, const poly_triangles& cut, const progress& on_progress);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/parametrize/detail/plane_maps.ipp>
#endif
