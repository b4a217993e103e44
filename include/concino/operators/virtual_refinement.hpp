// An alternative discretisation, for comparison: virtual refinement. Not part of <concino/operators.hpp>.
#pragma once

#include <concino/operators/detail/cotangent_weights.hpp>
#include <concino/operators/detail/virtual_refinement.hpp>
#include <concino/operators/discretisation.hpp>

namespace concino {

/// The cotangent Laplacian of the triangles or tets about one virtual point for each poly (and face), which is then
/// eliminated. For comparison with the default.
/// Needs:  EmbeddedMesh whose polys are star-shaped about that point.
/// Errors: of functions that use it: invalid_mesh if a poly has no area or volume or points that are not finite;
///         unsupported if one is not star-shaped about its virtual point.
/// Source: Bunge, Herholz, Kazhdan, Botsch 2020, "Polygon Laplacian made simple".
struct virtual_refinement_t {
  static constexpr bool scales_with_mesh = true;

  template<EmbeddedMesh M>
    requires (TriMesh<M> || TetMesh<M>)
  auto edge_weights(const M& m) const { return detail::cotangent_weights<M>(m, "virtual refinement"); }

  template<EmbeddedMesh M>
  auto poly_matrices(const M& m) const { return detail::virtual_refinement_element<M>(m); }
};
inline constexpr virtual_refinement_t virtual_refinement{};

}  // namespace concino
