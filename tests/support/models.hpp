// Checks which concepts a type models, in all forms of const and reference.
#pragma once

#include <concino/concepts/mesh.hpp>

namespace concino::testing {

/// A set of concepts, as a sum of these flags.
enum modelled {
  nothing = 0,
  primal_graph = 1,
  dual_graph = 2,
  surface_mesh = 4,
  volume_mesh = 8,
  any_mesh = 16,
  embedded = 32,
  mutable_points = 64,
  fixed_arity = 128,
  surface = primal_graph | dual_graph | surface_mesh | any_mesh,
  volume = primal_graph | dual_graph | volume_mesh | any_mesh
};

template<class M>
constexpr int models() {
  return (PrimalGraph<M> ? primal_graph : 0) | (DualGraph<M> ? dual_graph : 0) | (SurfaceMesh<M> ? surface_mesh : 0) |
         (VolumeMesh<M> ? volume_mesh : 0) | (AnyMesh<M> ? any_mesh : 0) | (Embedded<M> ? embedded : 0) |
         (MutablePoints<M> ? mutable_points : 0) | (TriMesh<M> || QuadMesh<M> || TetMesh<M> || HexMesh<M> ? fixed_arity : 0);
}

/// Whether M, const M, M&, const M& and M&& model exactly the concepts in `expected`.
template<class M>
constexpr bool models_in_all_forms(int expected) {
  return models<M>() == expected && models<const M>() == expected && models<M&>() == expected && models<const M&>() == expected &&
         models<M&&>() == expected;
}

}  // namespace concino::testing
