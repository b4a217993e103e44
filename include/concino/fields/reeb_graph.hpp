// reeb_graph: how the components of the level sets of a function begin, join, divide and end.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/fields/detail/topology/level_tracking.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace concino {

/// A graph whose nodes are verts of the mesh, and whose arcs have the verts between.
template<class V>
struct level_graph {
  struct arc {
    std::size_t lower, upper;           // in nodes
    std::size_t first_vert, last_vert;  // in verts
  };

  std::vector<V> nodes;   // by ascending values
  std::vector<arc> arcs;  // by their lower nodes
  std::vector<V> verts;   // of the arcs, arc by arc, ascending; with nodes these are all verts of the mesh

  std::span<const V> verts_of(const arc& a) const { return {verts.data() + a.first_vert, verts.data() + a.last_vert}; }
};

namespace detail {

template<class M>
level_graph<vert_t<M>> make_level_graph(const sorted_verts<M>& sorted, const std::vector<level_link>& links) {
  const contracted_links contracted = contract_links(links, sorted.size());
  level_graph<vert_t<M>> graph;
  std::vector<std::size_t> place(sorted.size());
  for (const std::uint32_t rank : contracted.nodes) {
    place[rank] = graph.nodes.size();
    graph.nodes.push_back(sorted.verts[rank]);
  }
  for (const contracted_links::arc& a : contracted.arcs)
    graph.arcs.push_back({place[a.lower], place[a.upper], a.first, a.last});
  for (const std::uint32_t rank : contracted.regular) graph.verts.push_back(sorted.verts[rank]);
  return graph;
}

}  // namespace detail

/// The Reeb graph of the function u of the verts: each component of a level set is one point of the graph. Its nodes
/// are the verts where components begin, join, divide or end; between them an arc follows one component upwards.
/// Needs:  AnyMesh, open or non-manifold too; u[v] is a finite number for each vert, readable from several threads.
/// Result: nodes and arcs, with the verts that components of each arc meet. Two arcs can have the same ends. Of a
///         closed orientable surface of genus g the graph has g loops, whatever u is, if each saddle has two valleys;
///         otherwise it can have fewer. Of verts with equal values, the one with the smaller index counts as the lower
///         one. u is linear on triangles and tets; polygons are fans of triangles about their highest verts, polyhedra
///         cones from theirs. A vert without edges is a node without arcs. Saddles of volumes that divide no component
///         are no nodes.
/// Cost:   O(k log k) time, amortised, and O(k) memory for k edges and corners.
/// Errors: invalid_argument that names a vert whose value is not finite.
/// Source: Reeb 1946; Parsa 2013, "A deterministic O(m log m) time algorithm for the Reeb graph"; Edelsbrunner, Harer
///         2010, "Computational topology".
template<AnyMesh M, class U>
  requires requirement::gives_numbers<U, vert_t<M>>
level_graph<vert_t<M>> reeb_graph(const M& m, const U& u) {
  const detail::sorted_verts<M> sorted(m, u, "reeb_graph");
  return detail::make_level_graph(sorted,
                                  detail::find_level_links(detail::make_level_complex(m, sorted), sorted.size()));
}

// What to write instead of calls that cannot compile.
template<class... T> void reeb_graph(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(AnyMesh<M> && !requirement::gives_numbers<U, vert_t<M>>)
void reeb_graph(const M&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
