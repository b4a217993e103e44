// The default discretisation: virtual elements of order 1, consistent on every polygon and polyhedron.
#pragma once

#include <concino/operators/detail/cotangent_weights.hpp>
#include <concino/operators/detail/virtual_elements.hpp>
#include <concino/operators/discretisation.hpp>

namespace concino {

/// Virtual elements of order 1: consistent on every polygon and polyhedron, even concave and non-planar ones; on
/// triangles and tets equal to cotangent. Linear functions are in the kernel at interior verts of planar surfaces and
/// of volumes, whatever the polys. Inverted polys count as if they were not inverted.
/// Needs:  EmbeddedMesh.
/// Errors: of functions that use it: invalid_mesh if a poly has no area or volume or points that are not finite.
/// Source: Beirao da Veiga et al. 2013, "Basic principles of virtual element methods".
struct virtual_elements_t {
  static constexpr bool scales_with_mesh = true;

  template<EmbeddedMesh M>
    requires (TriMesh<M> || TetMesh<M>)
  detail::cotangent_weights<M> edge_weights(const M& m)
  const { return {m, "virtual elements"}; }  // the same values, several times faster

  template<EmbeddedMesh M>
  detail::virtual_stiffness<M> poly_matrices(const M& m) const { return detail::virtual_stiffness<M>(m); }
};
inline constexpr virtual_elements_t virtual_elements{};

}  // namespace concino
