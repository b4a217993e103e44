// An alternative discretisation, for comparison: the polygon Laplacian of de Goes, Butts and Desbrun.
// Not part of <concino/operators.hpp>.
#pragma once

#include <concino/operators/detail/cotangent_weights.hpp>
#include <concino/operators/detail/de_goes.hpp>
#include <concino/operators/discretisation.hpp>

namespace concino {

/// The mean gradient of each polygon, plus a penalty for differences along its edges that deviate from it. For
/// comparison with the default.
/// Needs:  Embedded SurfaceMesh.
/// Errors: of functions that use it: invalid_mesh if a polygon has no area or points that are not finite.
/// Source: de Goes, Butts, Desbrun 2020, "Discrete differential operators on polygonal meshes".
struct de_goes_t {
  static constexpr bool scales_with_mesh = true;

  template<class M>
    requires SurfaceMesh<M> && Embedded<M> && TriMesh<M>
  auto edge_weights(const M& m) const { return detail::cotangent_weights<M>(m, "Laplacian of de Goes"); }

  template<class M>
    requires SurfaceMesh<M> && Embedded<M>
  auto poly_matrices(const M& m) const { return detail::de_goes_element<M>(m); }
};
inline constexpr de_goes_t de_goes{};

}  // namespace concino
