// The discretisation by linear finite elements: cotangent weights on the edges of triangles and tets.
#pragma once

#include <concino/operators/detail/cotangent_weights.hpp>
#include <concino/operators/discretisation.hpp>

namespace concino {

namespace requirement {

// cotangents need triangles or tets: use virtual_elements, or split the polys
template<class M> concept may_have_simplices = AnyMesh<M> && (arity_v<M> == 0 || arity_v<M> == dimension_v<M> + 1);

}  // namespace requirement

/// Linear finite elements on triangles and tets. The weight of an edge is the sum over its polys of minus the measure
/// times the scalar product of the gradients of the hat functions of its ends. On surfaces this is half the sum of the
/// cotangents of the angles opposite the edge. In volumes it is a sixth of the sum of the lengths of the opposite edges
/// times the cotangents of the dihedral angles there. Negative weights are kept: this makes linear functions harmonic.
/// Needs:  EmbeddedMesh of triangles or tets: by type or, if the type allows any number of verts, in fact.
/// Errors: of functions that use it: unsupported if some poly is no triangle or tet, invalid_mesh if one is degenerate.
/// Source: Pinkall, Polthier 1993 (triangles); Crane 2019, "The n-dimensional cotangent formula" (tets).
struct cotangent_t {
  static constexpr bool scales_with_mesh = true;

  template<EmbeddedMesh M>
    requires requirement::may_have_simplices<M>
  auto edge_weights(const M& m) const { return detail::cotangent_weights<M>(m, "cotangent weights"); }
};
inline constexpr cotangent_t cotangent{};

}  // namespace concino
