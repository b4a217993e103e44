// surface_adjacency: the finished tables of a surface, from an algorithm that can compute them faster than by a search for edges.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/flat_array.hpp>
#include <concino/mesh/detail/facet_adjacency_ranges.hpp>

#include <cstdint>
#include <vector>

namespace concino {

/// All adjacency of polygons of `Arity` verts, as surface_tables store it. A mesh that is constructed from it is the same as one that is constructed
/// from p2v alone, if the edges have the numbers that this gives them: they are sorted by their smaller end. The edges of one smaller end have the order in which
/// its polys, by increasing number, list them: of each poly first the edge behind the vert, then the edge before it.
/// Needs:  no edge with more than two polys, no two polys with more than one edge in common.
template<unsigned Arity>
struct surface_adjacency {
  core::flat_array<vert_id> p2v;                        // the verts of all polys, in cyclic order
  core::flat_array<edge_id> p2e;                        // edge k of a poly joins its verts k and k + 1
  core::flat_array<detail::encoded_neighbour> p2p;      // the other poly of that edge, or none
  core::flat_array<vert_id> e2v;                        // the two ends of each edge, the smaller one first
  core::flat_array<std::uint32_t> first_corner;         // of each edge: Arity * p + k, if it was met first as edge k of poly p
  std::vector<std::uint32_t> first_edge;                // where the edges of each vert begin, and where those of the last one end
  std::vector<std::uint32_t> first_poly;                // the same of polys; empty if it is the same
  core::flat_array<vert_id> v2v;                        // the other ends of the edges of each vert
  core::flat_array<edge_id> v2e;                        // the edges of each vert, ascending
  core::flat_array<poly_id> v2p;                        // the polys of each vert, ascending

  /// Allocates the memory for a surface of that size, uninitialised but for first_edge, which is 0. first_poly is empty. The arrays end with a large page and
  /// are allocated before any is written, so that the system need not make their pages one by one. shrink_to_fit() releases what is left.
  surface_adjacency(std::size_t vert_count, std::size_t edge_count, std::size_t poly_count) : first_edge(core::large_vector(vert_count + 1, 0u)) {
    const auto allocate = [](auto& values, std::size_t n) {
      const std::size_t bytes = n * sizeof values[0];
      values.reserve(core::whole_pages(bytes, bytes / 4) / sizeof values[0]);
      values.resize(n);
    };
    for_each_array(allocate, edge_count, poly_count);
  }
  void shrink_to_fit() {
    for_each_array([](auto& values, std::size_t) { values.shrink_to_fit(); }, 0, 0);
  }

 private:
  /// Calls f(array, its size).
  template<class F>
  void for_each_array(const F& f, std::size_t edge_count, std::size_t poly_count) {
    f(p2v, Arity * poly_count), f(p2e, Arity * poly_count), f(p2p, Arity * poly_count), f(e2v, 2 * edge_count), f(first_corner, edge_count);
    f(v2v, 2 * edge_count), f(v2e, 2 * edge_count), f(v2p, Arity * poly_count);
  }
};

}  // namespace concino
