// Chords: strips of quads across opposite edges, and rows of hexes across opposite faces.
#pragma once

#include <concino/core/local_numbers.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/layout/detail/opposite.hpp>
#include <concino/mesh/facet_map.hpp>

#include <algorithm>
#include <vector>

namespace concino {

/// The facets of a chord, edges of quads or faces of hexes, each opposite to the next one in the poly between them:
/// polys[i] lies between facets[i] and facets[i + 1]. If the chord is closed, the last poly lies between the last facet
/// and the first one.
template<class M>
struct chord {
  std::vector<facet_t<M>> facets;
  std::vector<poly_t<M>> polys;  // one that the chord crosses twice, or a hex three times, is there as often
  bool is_closed = false;        // it has no end at the boundary
  bool crosses_itself = false;   // it passes through a poly more than once
  bool branches = false;         // it has a facet with more than two polys; facets and polys are then in the order of a
                                 // search
};

namespace detail {

/// Walks from `f` into p, until a facet with another number of polys than two, or f again. Returns whether it came
/// back.
template<class M>
bool walk_chord(const M& m, const facet_t<M>& f, poly_t<M> p, chord<M>& c, const char* caller) {
  facet_t<M> at = f;
  for (;;) {
    c.polys.push_back(p);
    at = opposite_facet(m, p, at, caller);
    if (at == f) return true;
    c.facets.push_back(at);
    std::size_t num_polys_at = 0;
    poly_t<M> next = p;
    for (const poly_t<M> q : adj_facet2p(m, at)) {
      ++num_polys_at;
      if (!(q == p)) next = q;
    }
    c.branches = c.branches || num_polys_at > 2;
    if (num_polys_at != 2) return false;
    p = next;
  }
}

/// All facets of the chord of f, in the order of a search.
template<class M>
chord<M> search_chord(const M& m, const facet_t<M>& f, const char* caller) {
  chord<M> c{{f}, {}, true, false, true};
  core::local_numbers found;
  found.add(index_of(m, f));
  for (std::size_t i = 0; i < c.facets.size(); ++i) {
    std::size_t num_polys_at = 0;
    for (const poly_t<M> p : adj_facet2p(m, c.facets[i])) {
      ++num_polys_at;
      const facet_t<M> next = opposite_facet(m, p, facet_t<M>(c.facets[i]), caller);
      const unsigned n = found.add(index_of(m, next));
      if (n == c.facets.size()) c.facets.push_back(next);
      if (n > i) c.polys.push_back(p);  // later, from the other facet, it is not added again
    }
    c.is_closed = c.is_closed && num_polys_at > 1;
  }
  return c;
}

template<class M>
bool has_poly_twice(const M& m, const chord<M>& c) {
  core::local_numbers numbers;
  for (const poly_t<M>& p : c.polys) numbers.add(index_of(m, p));
  return numbers.size() < c.polys.size();
}

template<class M>
chord<M> chord_through(const M& m, const facet_t<M>& f, const char* caller) {
  chord<M> c{{f}, {}};
  bool is_first = true;
  for (const poly_t<M> p : adj_facet2p(m, f)) {
    if (!is_first) {  // the other end: what was found so far comes behind f
      std::reverse(c.facets.begin(), c.facets.end());
      std::reverse(c.polys.begin(), c.polys.end());
    }
    c.branches = c.branches || num_elements(adj_facet2p(m, f)) > 2;
    if (c.branches || (c.is_closed = walk_chord(m, f, p, c, caller))) break;
    is_first = false;
  }
  if (c.branches) c = search_chord(m, f, caller);
  c.crosses_itself = has_poly_twice(m, c);
  return c;
}

}  // namespace detail

/// The chord through a facet: of quads the strip of quads across opposite edges, of hexes the row of hexes across
/// opposite faces.
/// Needs:  a surface whose polys are quads, or a HexMesh; an edge of the surface, a face of the hexes.
/// Result: its facets and polys in order. A closed chord begins with f; a facet without polys is a chord of its own,
///         without polys.
/// Cost:   O(polys of the chord).
/// Errors: invalid_mesh if f is not a facet of m, or one of the polys is not a quad or a hex.
/// Source: Borden, Benzley, Shepherd 2002, "Hexahedral sheet extraction".
template<requirement::may_be_quads_or_hexes M>
chord<M> chord_of(const M& m, facet_t<M> f) {
  detail::check_member(m, f, "chord_of", dimension_v<M> == 2 ? "edge" : "face");
  return detail::chord_through(m, f, "chord_of");
}

/// All chords. Each facet belongs to exactly one.
/// Needs:  as chord_of.
/// Result: the chords in the order of their first facets in facets(m). Together they have each quad twice and each hex
///         three times.
/// Cost:   O(facets).
/// Errors: invalid_mesh if a poly is not a quad or a hex.
template<requirement::may_be_quads_or_hexes M>
std::vector<chord<M>> chords(const M& m) {
  std::vector<chord<M>> all;
  auto is_known = make_facet_map<bool>(m, false);
  for (const facet_t<M> f : facets(m)) {
    if (is_known[f]) continue;
    all.push_back(detail::chord_through(m, f, "chords"));
    for (const facet_t<M>& x : all.back().facets) is_known[x] = true;
  }
  return all;
}

// What to write instead of calls that cannot compile.
template<class... T> void chord_of(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void chord_of(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void chords(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
