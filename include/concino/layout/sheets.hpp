// Sheets: all edges of a mesh of hexes that are parallel to one another, and the hexes between their ends.
#pragma once

#include <concino/core/local_numbers.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/layout/detail/opposite.hpp>
#include <concino/mesh/element_map.hpp>

#include <vector>

namespace concino {

/// The edges that parallel edges of hexes lead to, and the hexes that have them, in the order of a search.
template<class M>
struct sheet {
  std::vector<edge_t<M>> edges;
  std::vector<poly_t<M>> polys;          // each once
  std::vector<unsigned char> crossings;  // how often, 1 to 3 times, the sheet crosses each of these
  bool is_closed = false;                // none of its edges is at the boundary
  bool crosses_itself = false;           // it crosses a hex more than once
  bool touches_itself = false;           // two of its edges have a common vert; so have those of one that crosses
                                         // itself
};

namespace detail {

template<class M>
sheet<M> sheet_through(const M& m, const edge_t<M>& e, const char* caller) {
  sheet<M> s{{e}, {}, {}, true};
  core::local_numbers edge_numbers, poly_numbers, verts;
  std::vector<unsigned char> uses;  // by number of a poly, four for each time that the sheet crosses it
  edge_numbers.add(index_of(m, e));
  for (std::size_t i = 0; i < s.edges.size(); ++i) {
    const edge_t<M> at = s.edges[i];
    bool has_polys = false;
    for (const poly_t<M> p : adj_e2p(m, at)) {
      has_polys = true;
      const unsigned n = poly_numbers.add(index_of(m, p));
      if (n == s.polys.size()) s.polys.push_back(p), uses.push_back(0);
      ++uses[n];
      for (const edge_t<M>& x : parallel_edges(m, p, at, caller))
        if (edge_numbers.add(index_of(m, x)) == s.edges.size()) s.edges.push_back(x);
    }
    s.is_closed = s.is_closed && has_polys && !is_boundary(m, at);
    for (const vert_t<M> v : adj_e2v(m, at)) verts.add(index_of(m, v));
  }
  for (const unsigned char n : uses) {
    s.crossings.push_back(static_cast<unsigned char>(n / 4));
    s.crosses_itself = s.crosses_itself || n > 4;
  }
  s.touches_itself = verts.size() < 2 * s.edges.size();
  return s;
}

}  // namespace detail

/// The sheet through an edge.
/// Needs:  HexMesh M, an edge of it.
/// Result: the edges that parallel edges of hexes lead to from e, e first, and their hexes. An edge without polys is a
///         sheet of its own, without polys.
/// Cost:   O(polys of the sheet).
/// Errors: invalid_mesh if e is not an edge of m.
/// Source: Borden, Benzley, Shepherd 2002, "Hexahedral sheet extraction"; paper section 4.
template<HexMesh M>
sheet<M> sheet_of(const M& m, edge_t<M> e) {
  detail::check_member(m, e, "sheet_of", "edge");
  return detail::sheet_through(m, e, "sheet_of");
}

/// All sheets. Each edge belongs to exactly one.
/// Needs:  HexMesh M.
/// Result: the sheets in the order of their first edges in edges(m). Together they cross each hex three times.
/// Cost:   O(polys).
/// Errors: none.
template<HexMesh M>
std::vector<sheet<M>> sheets(const M& m) {
  std::vector<sheet<M>> all;
  auto is_known = make_edge_map<bool>(m, false);
  for (const edge_t<M> e : edges(m)) {
    if (is_known[e]) continue;
    all.push_back(detail::sheet_through(m, e, "sheets"));
    for (const edge_t<M>& x : all.back().edges) is_known[x] = true;
  }
  return all;
}

// What to write instead of calls that cannot compile.
template<class... T> void sheet_of(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void sheet_of(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void sheets(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
