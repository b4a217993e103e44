// regions_of_maxima, regions_of_minima: the verts of a graph by the hill that they belong to, or by the valley.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/fields/detail/topology/sorted_graph.hpp>
#include <concino/mesh/element_map.hpp>

#include <cstdint>
#include <vector>

namespace concino {

/// regions[v] is the number of the region of v: regions.extrema[regions[v]] is the maximum, or minimum, to which the
/// steepest path from v leads.
template<class M>
struct extremum_regions {
  std::vector<vert_t<M>> extrema;  // the highest maximum first, or the lowest minimum
  vert_map<M, int> labels;

  int operator[](const vert_t<M>& v) const { return labels[v]; }
};

namespace detail {

/// Visits the verts from the extrema on, so that the steepest neighbour of each has its label already.
template<class M, class U>
extremum_regions<M> find_regions(const M& m, const U& u, bool of_maxima, const char* caller) {
  const sorted_verts<M> sorted(m, u, caller);
  const ranked_graph g = make_ranked_graph(m, sorted);
  extremum_regions<M> regions{{}, make_vert_map<int>(m, -1)};
  std::vector<int> label(g.size());
  for (std::uint32_t k = 0; k < g.size(); ++k) {
    const std::uint32_t rank = of_maxima ? g.size() - 1 - k : k;
    std::uint32_t steepest = rank;
    for (const std::uint32_t neighbour : g.neighbours(rank))
      if (of_maxima ? neighbour > steepest : neighbour < steepest) steepest = neighbour;
    if (steepest == rank) {
      label[rank] = static_cast<int>(regions.extrema.size());
      regions.extrema.push_back(sorted.verts[rank]);
    } else {
      label[rank] = label[steepest];
    }
    regions.labels[sorted.verts[rank]] = label[rank];
  }
  return regions;
}

}  // namespace detail

/// The regions of the verts from which the steepest ascent leads to the same maximum: from each vert on to its highest
/// neighbour, as long as that is higher. regions_of_minima is the same for descents.
/// Needs:  PrimalGraph, not a temporary; u[v] is a finite number for each vert, readable from several threads.
/// Result: regions.extrema, the highest first, and a number for each vert. Of neighbours with equal values, the one
///         with the larger index counts as higher. Each region is connected. The steepest neighbour is that with the
///         greatest difference of u, whatever the lengths of edges are. To have few and large regions, use
///         simplified(m, u, {.maxima_below = ...}) first.
/// Cost:   O(V log V + E) time, O(V + E) memory.
/// Errors: invalid_argument that names a vert whose value is not finite.
/// Source: Maxwell 1870, "On hills and dales"; Meyer 1994, "Topographic distance and watershed lines".
template<class M, class U>
  requires requirement::is_lvalue_or_view<M> && PrimalGraph<M> && requirement::gives_numbers<U, vert_t<M>>
extremum_regions<std::remove_cvref_t<M>> regions_of_maxima(M&& m, const U& u) {
  return detail::find_regions<std::remove_cvref_t<M>>(m, u, true, "regions_of_maxima");
}
template<class M, class U>
  requires requirement::is_lvalue_or_view<M> && PrimalGraph<M> && requirement::gives_numbers<U, vert_t<M>>
extremum_regions<std::remove_cvref_t<M>> regions_of_minima(M&& m, const U& u) {
  return detail::find_regions<std::remove_cvref_t<M>>(m, u, false, "regions_of_minima");
}

// What to write instead of calls that cannot compile.
template<class... T> void regions_of_maxima(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void regions_of_maxima(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void regions_of_minima(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void regions_of_minima(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
