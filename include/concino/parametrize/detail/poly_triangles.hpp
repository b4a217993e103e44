// The triangles of polys, each laid into the plane: what maps to the plane are measured and computed with.
#pragma once

#include <concino/parametrize/detail/flat_polys.hpp>
#include <concino/parametrize/uv_map.hpp>

#include <array>
#include <vector>

namespace concino::detail {

/// A matrix of 2 x 2: the derivative of a map on a triangle.
struct plane_matrix {
  double xx = 0, xy = 0, yx = 0, yy = 0;
  double determinant() const { return xx * yy - xy * yx; }
};

/// The largest and the smallest factor by which a matrix changes lengths; the second is negative if it mirrors.
/// Source: the singular values as the sum and difference of the lengths of the conformal and anticonformal parts.
std::array<double, 2> singular_values(const plane_matrix& j);

/// A triangle in the plane: the gradients of its three linear functions, and its area.
struct plane_triangle {
  std::array<std::uint32_t, 3> corner;  // in flat_polys
  std::array<std::array<double, 2>, 3> gradient;
  double area;

  /// The derivative of the map to three points.
  plane_matrix derivative(const uv_point& a, const uv_point& b, const uv_point& c) const;
};

/// The triangles that diagonals cut polys into. Their circumcircles are empty within their poly, so that they depend on
/// its shape alone; of several such cuts, that of polygon_triangulator.
struct poly_triangles {
  std::vector<plane_triangle> triangles;
  std::vector<std::uint32_t> first{0};  // those of poly p: first[p] to first[p + 1]
  double area = 0;

  /// Triangles without area have gradients of 0 and the area 0.
  explicit poly_triangles(const flat_polys& f);

  /// Errors: invalid_mesh if a triangle has no area.
  void check_areas(const flat_polys& f, const char* caller) const;
};

/// Twice the signed area of a triangle in the plane.
inline double twice_area(const uv_point& a, const uv_point& b, const uv_point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/parametrize/detail/poly_triangles.ipp>
#endif
