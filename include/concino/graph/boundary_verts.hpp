// boundary_verts(m): the boundary verts of a surface or a volume, as a map of bool.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/mesh/element_map.hpp>

namespace concino {

/// Whether each vert is on the boundary: it belongs to a facet with exactly one poly. This is one pass over all facets;
/// is_boundary(m, v) tests the facets of one vert.
/// Needs:  AnyMesh, no temporary.
/// Result: a map of bool.                                                          Cost: O(verts of all facets) time, a
///         byte per vert.
/// Errors: none.
template<class M>
  requires requirement::is_lvalue_or_view<M> && AnyMesh<M>
vert_map<M, bool> boundary_verts(M&& m) {
  auto on_boundary = make_vert_map<bool>(m, false);
  for (const facet_t<M> x : facets(m)) {
    if (!is_boundary(m, x)) continue;
    for (const vert_t<M> v : adj_facet2v(m, x)) on_boundary[v] = true;
  }
  return on_boundary;
}

// What to write instead of calls that cannot compile.
template<class... T> void boundary_verts(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void boundary_verts(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
