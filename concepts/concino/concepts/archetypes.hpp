// Archetypes: a real mesh stripped down to one concept, to run an algorithm on. What compiles on `only_primal_graph(m)` uses what
// PrimalGraph promises and nothing more, and its results can be compared with those on m, descriptor by descriptor.
//
//   auto g = only_primal_graph(m);
//   auto d = bfs(g, g.vert(v));                    // g.vert, g.edge, g.face, g.poly: a descriptor of m made opaque
//   for (auto v : verts(g)) d[v] ... g.base(v)     // g.base: the descriptor of m again
//
// Needs:  a mesh or graph m that models the concept, and that outlives the result; a temporary one is refused.
// Result: a view of m that models the concepts named above the function, and no others. Its descriptors, ranges, numbers and points can do what
//         the concepts ask for, and nothing else.
// Cost:   none; questions cost what they cost on m.
// Errors: none.
#pragma once

#include <concino/concepts/archetypes/opaque.hpp>
#include <concino/concepts/archetypes/traits.hpp>
#include <concino/concepts/mesh.hpp>

namespace concino {

/// m stripped to PrimalGraph: verts and adj_v2v.
template<PrimalGraph M> constexpr auto only_primal_graph(const M& m) { return archetypes::archetype<M, archetypes::primal>(m); }
template<class M> void only_primal_graph(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m stripped to PrimalGraph and Embedded.
template<EmbeddedGraph M> constexpr auto only_embedded_graph(const M& m) { return archetypes::archetype<M, archetypes::primal | archetypes::points>(m); }
template<class M> void only_embedded_graph(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m stripped to DualGraph: polys and adj_p2p.
template<DualGraph M> constexpr auto only_dual_graph(const M& m) { return archetypes::archetype<M, archetypes::dual>(m); }
template<class M> void only_dual_graph(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m stripped to PrimalGraph and DualGraph: no edges or faces, nothing from verts to polys.
template<PrimalGraph M>
  requires DualGraph<M>
constexpr auto only_graphs(const M& m) { return archetypes::archetype<M, archetypes::primal | archetypes::dual>(m); }
template<class M> void only_graphs(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m stripped to Embedded: a point per vert, no way to find the verts.
template<Embedded M> constexpr auto only_embedded(const M& m) { return archetypes::archetype<M, archetypes::points>(m); }
template<class M> void only_embedded(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m stripped to SurfaceMesh: polygons of any arity, no points.
template<SurfaceMesh M> constexpr auto only_surface_mesh(const M& m) { return archetypes::archetype<M, archetypes::mesh>(m); }
template<class M> void only_surface_mesh(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m stripped to VolumeMesh: polyhedra of any shape, no points.
template<VolumeMesh M> constexpr auto only_volume_mesh(const M& m) { return archetypes::archetype<M, archetypes::mesh>(m); }
template<class M> void only_volume_mesh(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m stripped to SurfaceMesh or VolumeMesh, whichever it is, without points.
template<AnyMesh M> constexpr auto only_mesh(const M& m) { return archetypes::archetype<M, archetypes::mesh>(m); }
template<class M> void only_mesh(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// m stripped to SurfaceMesh or VolumeMesh, and Embedded.
template<EmbeddedMesh M> constexpr auto only_embedded_mesh(const M& m) { return archetypes::archetype<M, archetypes::mesh | archetypes::points>(m); }
template<class M> void only_embedded_mesh(const M&& m) = delete;  // give the mesh a name: auto m = ...;

/// The same, and still known to be of triangles, quads, tets or hexes: TriMesh, QuadMesh, TetMesh or HexMesh, and Embedded.
template<EmbeddedMesh M>
  requires(arity_v<M> > 0)
constexpr auto only_fixed_arity_mesh(const M& m) { return archetypes::archetype<M, archetypes::mesh | archetypes::points | archetypes::arity>(m); }
template<class M> void only_fixed_arity_mesh(const M&& m) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
