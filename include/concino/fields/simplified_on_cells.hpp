// simplified_on_cells: a function on the verts, edges and polys of a surface, without small minima and small maxima,
// both at once.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/fields/detail/topology/cell_simplification.hpp>
#include <concino/mesh/element_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino {

struct simplify_cells_options {
  double below = 0;  // extrema of less persistence are removed, in units of u, above 0; infinite: all but one in each
                     // component
};

/// A function on all cells of a surface.
template<class M>
struct cell_function {
  vert_map<M, double> verts;
  edge_map<M, double> edges;
  poly_map<M, double> polys;
  std::array<std::size_t, 3> count{};  // of critical cells, by dimension: verts that are minima, edges that are
                                       // saddles, polys that are maxima

  double operator[](const vert_t<M>& v) const { return verts[v]; }
  double operator[](const edge_t<M>& e) const { return edges[e]; }
  double operator[](const poly_t<M>& p) const { return polys[p]; }
};

/// The function of the verts, edges and polys of a surface without all minima and maxima whose persistence is less than
/// a threshold, and with as few changes as possible. Verts alone have too little room for that. At the verts of
/// subdivide_barycentric(m), which belong to verts, edges and polys, the critical points are the critical cells.
/// Needs:  SurfaceMesh with at most two polys at each edge, open or closed, not a temporary; u[v] is a finite number
///         for each vert, readable from several threads.
/// Result: values at all cells. They differ from the function that at each cell is the largest value of its verts by at
///         most half of the threshold, and by steps of one unit in the last place, so that ties need no care. Its
///         minima are those of u with at least that persistence. On closed surfaces of triangles, as many maxima are
///         left as u has with at least that persistence. On open ones, a maximum is also paired with the highest pass
///         to the boundary. Maxima of polygons are those of cells: each counts for its highest vert. The alternating
///         sum of count is the Euler characteristic.
/// Cost:   O(n log n) time, O(n) memory for n cells.
/// Errors: unsupported that names an edge with more than two polys. invalid_argument that names a vert whose value is
///         not finite, or if the threshold is not above 0.
/// Source: Bauer, Lange, Wardetzky 2012, "Optimal topological simplification of discrete functions on surfaces".
template<class M, class U>
  requires requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && requirement::gives_numbers<U, vert_t<M>>
cell_function<std::remove_cvref_t<M>> simplified_on_cells(M&& m, const U& u, const simplify_cells_options& options) {
  using mesh = std::remove_cvref_t<M>;
  detail::check_cell_threshold(options.below);
  const detail::sorted_verts<mesh> sorted(m, u, "simplified_on_cells");
  detail::surface_cells cells;
  std::vector<std::uint32_t> number(poly_index_bound(m));
  for (const poly_t<mesh> p : polys(m)) number[index_of(m, p)] = static_cast<std::uint32_t>(cells.polys++);
  for (const edge_t<mesh> e : edges(m)) {
    const auto ends = end_verts(m, e);
    cells.edge_verts.push_back({sorted.rank[index_of(m, ends.first)], sorted.rank[index_of(m, ends.second)]});
    auto& sides = cells.edge_polys.emplace_back(std::array{detail::no_rank, detail::no_rank});
    std::size_t n = 0;
    for (const poly_t<mesh> p : adj_e2p(m, e)) {
      if (n == 2) detail::throw_non_manifold_edge(index_of(m, e));
      sides[n++] = number[index_of(m, p)];
    }
  }
  const double largest = sorted.size() > 0 ? sorted.values.back() / 2 - sorted.values.front() / 2 : 0;
  // no pair is more persistent; infinite values would result
  const double threshold = options.below / 2 > largest ? 2 * largest * (1 + 1e-15) : options.below;
  const detail::simplified_cells simple = detail::simplify_cells(cells, sorted.values, threshold);
  cell_function<mesh> result{make_vert_map<double>(m), make_edge_map<double>(m), make_poly_map<double>(m),
                             simple.critical};
  for (std::uint32_t rank = 0; rank < sorted.size(); ++rank) result.verts[sorted.verts[rank]] = simple.verts[rank];
  std::size_t k = 0;
  for (const edge_t<mesh> e : edges(m)) result.edges[e] = simple.edges[k++];
  for (const poly_t<mesh> p : polys(m)) result.polys[p] = simple.polys[number[index_of(m, p)]];
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void simplified_on_cells(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void simplified_on_cells(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(SurfaceMesh<M> && !requirement::gives_numbers<U, vert_t<M>>)
void simplified_on_cells(M&&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
