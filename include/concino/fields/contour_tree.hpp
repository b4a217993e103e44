// contour_tree: the Reeb graph of a function on a mesh without loops, in less time.
#pragma once

#include <concino/fields/detail/topology/first_betti_number.hpp>
#include <concino/fields/reeb_graph.hpp>

namespace concino {

namespace detail {

[[noreturn]] void throw_has_loops(std::ptrdiff_t loops);

}  // namespace detail

/// The contour tree of the function u of the verts: the Reeb graph of a mesh in which every loop can be filled, such as
/// a disk, a sphere, a ball or a ball with cavities.
/// Needs:  AnyMesh with at most two polys at each facet; volumes with at most two boundary faces at each edge. u[v] is
///         a finite number for each vert, readable from several threads.
/// Result: as reeb_graph: a tree for each component, with the verts of each arc.
/// Cost:   O(V log V + k) time, up to an inverse Ackermann factor, and O(k) memory for k edges and corners: a fraction
///         of that of reeb_graph.
/// Errors: unsupported if the mesh has loops that it does not fill (a torus, an annulus), or if their number is not
///         known, naming the element that is not manifold. invalid_argument that names a vert whose value is not
///         finite.
/// Source: Carr, Snoeyink, Axen 2003, "Computing contour trees in all dimensions".
template<AnyMesh M, class U>
  requires requirement::gives_numbers<U, vert_t<M>>
level_graph<vert_t<M>> contour_tree(const M& m, const U& u) {
  if (const std::ptrdiff_t loops = detail::count_loops(m, "contour_tree"); loops != 0) detail::throw_has_loops(loops);
  const detail::sorted_verts<M> sorted(m, u, "contour_tree");
  return detail::make_level_graph(
      sorted, detail::merge_join_and_split_trees(detail::make_level_complex(m, sorted), sorted.size()));
}

// What to write instead of calls that cannot compile.
template<class... T> void contour_tree(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(AnyMesh<M> && !requirement::gives_numbers<U, vert_t<M>>)
void contour_tree(const M&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/topology/contour_tree.ipp>
#endif
