// Lengths of edges.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/element_map.hpp>

namespace concino {

/// The distance between the ends of edge e.
/// Needs:  Embedded M with adj_e2v.      Result: 0 or more, in units of the mesh; scales exactly.      Cost: O(1).     
///         Errors: none.
template<Embedded M>
  requires requires(const M& m, edge_t<M> e) { adj_e2v(m, e); }
double edge_length(const M& m, const edge_t<M>& e) {
  const auto [a, b] = end_verts(m, e);
  return distance(to_vec3(point(m, a)), to_vec3(point(m, b)));
}

/// The lengths of all edges.
/// Needs:  EmbeddedMesh, no temporary.      Result: a map of double.      Cost: O(E), parallel.      Errors: none.
template<class M>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M>
edge_map<M, double> edge_lengths(M&& m) {
  edge_map<M, double> length(m, edge_index_bound(m), detail::unwritten{});
  parallel_for_each(edges(m), [&](const edge_t<M>& e) { length[e] = edge_length(m, e); });
  return length;
}

// What to write instead of calls that cannot compile.
template<class... T> void edge_length(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void edge_length(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void edge_length(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void edge_lengths(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void edge_lengths(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void edge_lengths(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
