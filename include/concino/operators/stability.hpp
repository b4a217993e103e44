// How far the virtual elements of a poly are from losing their stability, as polys with short edges or thin parts do.
// Not part of <concino/operators.hpp>: without concino::compiled it includes the eigenvalues of Eigen, which take long
// to compile.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/operators/virtual_elements.hpp>

#include <cstddef>
#include <vector>

namespace concino {

/// The smallest over the largest eigenvalue of the matrix that `virtual_elements` gives a regular polygon of n verts,
/// without the constants: 1 for a triangle and a hexagon, 2/3 for a square, 6/n for larger polygons.
/// Needs:  n >= 3.      Result: in (0, 1].      Cost: O(1).      Errors: none.
constexpr double regular_eigenvalue_ratio(std::size_t n) {
  const auto x = static_cast<double>(n);
  return n == 3 ? 1 : n < 6 ? x / 6 : 6 / x;
}
/// The same of a regular hexagon and of a cube.
inline constexpr double hexagon_eigenvalue_ratio = regular_eigenvalue_ratio(6), cube_eigenvalue_ratio = 2.0 / 3;

namespace detail {

/// Of a symmetric n x n matrix whose kernel is the constants, by its lower triangle row after row.
double eigenvalue_ratio(const std::vector<double>& lower_triangle, std::size_t n);

}  // namespace detail

/// The stability of poly p: the smallest over the largest eigenvalue of its virtual-element matrix, without the
/// constants, divided by that of the regular polygon with as many verts, or of the cube. Where it is small, systems of
/// equations are badly conditioned and errors large.
/// Needs:  EmbeddedMesh, a poly of m.
/// Result: 1 for regular polygons and cubes, near 0 for bad shapes; some others have more than 1. It does not depend on
///         the size. 0 for polys without area or volume, or with points that are not finite.
/// Cost:   O(n^3) for a poly of n verts.      Errors: none.
template<EmbeddedMesh M>
double stability(const M& m, const poly_t<M>& p) {
  local_matrix<vert_t<M>> k;
  try {
    virtual_elements.poly_matrices(m)(p, k);
  } catch (const invalid_mesh&) {
    return 0;
  }
  const double ratio = detail::eigenvalue_ratio(k.entries, k.size());
  if constexpr (SurfaceMesh<M>) return ratio / regular_eigenvalue_ratio(k.size());  // cells: by the cube's
  else return ratio / cube_eigenvalue_ratio;
}

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/operators/detail/stability.ipp>
#endif
