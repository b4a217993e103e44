// Archetypes: views that reduce a real mesh to one concept, for tests of algorithms. Code that compiles on
// `only_primal_graph(m)` uses only what PrimalGraph requires, and its results can be compared with those on m,
// descriptor by descriptor.
//
//   auto g = only_primal_graph(m);
//   auto d = bfs(g, g.vert(v));                    // g.vert, g.edge, g.face, g.poly: an opaque descriptor for one of m
//   for (auto v : verts(g)) d[v] ... g.base(v)     // g.base: the descriptor of m
//
// Needs:  a mesh or graph m that models the concept, and that outlives the result; a temporary one is refused.
// Result: a view of m that models the concepts named above the function, and no others. Its descriptors, ranges,
//         numbers and points have the operations that the concepts require, and no others.
// Cost:   none; each verb costs what it costs on m.
// Errors: none.
#pragma once

#include <concino/concepts/archetypes/editable.hpp>
#include <concino/concepts/archetypes/opaque.hpp>
#include <concino/concepts/archetypes/traits.hpp>
#include <concino/concepts/mesh.hpp>

namespace concino {

/// m reduced to PrimalGraph: verts and adj_v2v.
template<PrimalGraph M>
constexpr auto only_primal_graph(const M& m) {
  return archetypes::archetype<M, archetypes::primal>(m);
}
template<class M> void only_primal_graph(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m reduced to PrimalGraph and Embedded.
template<EmbeddedGraph M>
constexpr auto only_embedded_graph(const M& m) {
  return archetypes::archetype<M, archetypes::primal | archetypes::points>(m);
}
template<class M> void only_embedded_graph(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m reduced to DualGraph: polys and adj_p2p.
template<DualGraph M>
constexpr auto only_dual_graph(const M& m) {
  return archetypes::archetype<M, archetypes::dual>(m);
}
template<class M> void only_dual_graph(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m reduced to PrimalGraph and DualGraph: no edges or faces, no adjacency from verts to polys.
template<PrimalGraph M>
  requires DualGraph<M>
constexpr auto only_graphs(const M& m) { return archetypes::archetype<M, archetypes::primal | archetypes::dual>(m); }
template<class M> void only_graphs(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m reduced to Embedded: a point per vert, no range of verts.
template<Embedded M>
constexpr auto only_embedded(const M& m) {
  return archetypes::archetype<M, archetypes::points>(m);
}
template<class M> void only_embedded(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m reduced to SurfaceMesh: polygons of any arity, no points.
template<SurfaceMesh M>
constexpr auto only_surface_mesh(const M& m) {
  return archetypes::archetype<M, archetypes::mesh>(m);
}
template<class M> void only_surface_mesh(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m reduced to VolumeMesh: polyhedra of any shape, no points.
template<VolumeMesh M>
constexpr auto only_volume_mesh(const M& m) {
  return archetypes::archetype<M, archetypes::mesh>(m);
}
template<class M> void only_volume_mesh(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m reduced to SurfaceMesh or VolumeMesh, according to its dimension, without points.
template<AnyMesh M> constexpr auto only_mesh(const M& m) { return archetypes::archetype<M, archetypes::mesh>(m); }
template<class M> void only_mesh(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m reduced to SurfaceMesh or VolumeMesh, and Embedded.
template<EmbeddedMesh M>
constexpr auto only_embedded_mesh(const M& m) {
  return archetypes::archetype<M, archetypes::mesh | archetypes::points>(m);
}
template<class M> void only_embedded_mesh(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// The same with fixed arity: TriMesh, QuadMesh, TetMesh or HexMesh, and Embedded.
template<EmbeddedMesh M>
  requires(arity_v<M> > 0)
constexpr auto only_fixed_arity_mesh(const M& m) {
  return archetypes::archetype<M, archetypes::mesh | archetypes::points | archetypes::arity>(m);
}
template<class M> void only_fixed_arity_mesh(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m reduced to EditableMesh, that is to EditableSurfaceMesh or EditableVolumeMesh, according to its dimension. Edits
/// of the result change m.
template<EditableMesh M>
  requires(!std::is_const_v<M>)
constexpr auto only_editable_mesh(M& m) { return archetypes::editable<M>(m); }
template<class M> void only_editable_mesh(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m reduced to EditableSurfaceMesh.
template<EditableSurfaceMesh M>
  requires(!std::is_const_v<M>)
constexpr auto only_editable_surface_mesh(M& m) { return archetypes::editable<M>(m); }
template<class M> void only_editable_surface_mesh(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m reduced to EditableVolumeMesh.
template<EditableVolumeMesh M>
  requires(!std::is_const_v<M>)
constexpr auto only_editable_volume_mesh(M& m) { return archetypes::editable<M>(m); }
template<class M> void only_editable_volume_mesh(const M&& m) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
