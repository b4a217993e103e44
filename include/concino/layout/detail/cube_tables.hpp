// cube_tables: the quads or hexes of a mesh as squares or cubes with axes, and who meets whom at their ridges, the
// verts of a surface or the edges of a volume.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/layout/detail/opposite.hpp>
#include <concino/mesh/support/arrays_of.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// For each of some elements, where polys list it: poly and position in the list.
class poly_incidence {
  std::vector<std::uint32_t> first_, entries_;

 public:
  poly_incidence() = default;
  poly_incidence(const std::vector<std::uint32_t>& lists, std::size_t num_elements);
  std::size_t count(std::size_t x) const { return first_[x + 1] - first_[x]; }
  /// The n-th place in the lists that has x.
  std::uint32_t entry(std::size_t x, std::size_t n) const { return entries_[first_[x] + n]; }
};

/// Elements have numbers without gaps, in the order of their ranges. Places of corners, edges and facets in a poly are
/// those of opposite.hpp: facet 2 a + s lies at the end s of axis a, and edge a 2^(dimension - 1) + n is the n-th along
/// axis a.
struct cube_tables {
  static constexpr std::uint32_t none = ~0u;

  unsigned dimension = 2;
  std::size_t num_verts = 0, num_edges = 0, num_facets = 0;
  std::vector<std::uint32_t> poly_verts, poly_edges, poly_facets;
  poly_incidence at_facets, at_ridges;  // by prepare()

  unsigned num_corners() const { return 1u << dimension; }
  unsigned num_poly_edges() const { return dimension << (dimension - 1); }
  unsigned num_poly_facets() const { return 2 * dimension; }
  std::size_t num_polys() const { return poly_facets.size() / num_poly_facets(); }
  std::size_t num_ridges() const { return dimension == 2 ? num_verts : num_edges; }
  unsigned num_poly_ridges() const { return dimension == 2 ? 4 : 12; }
  const std::vector<std::uint32_t>& poly_ridges() const { return dimension == 2 ? poly_verts : poly_edges; }

  void prepare();
  /// The cell of p that extends along some axes, a set of bits, from the corner `place` on: a vert, edge, facet or
  /// poly.
  std::uint32_t cell(std::size_t p, unsigned axes, unsigned place) const;
  /// The two facets of a poly that meet at its ridge k, as places.
  std::pair<unsigned, unsigned> facets_at(unsigned k) const;
  std::uint32_t facet(std::size_t p, unsigned place) const { return poly_facets[p * num_poly_facets() + place]; }
  /// The place of a facet or of a ridge in p.
  unsigned place_of_facet(std::size_t p, std::uint32_t f) const;
  unsigned place_of_ridge(std::size_t p, std::uint32_t r) const;
  /// The poly on the other side of a facet, if it has two; else none.
  std::uint32_t other_poly(std::size_t p, std::uint32_t f) const;
  /// The other facet of p at r.
  std::uint32_t next_facet(std::size_t p, std::uint32_t f, std::uint32_t r) const;
  /// The ridges of a facet that has polys, as places in the lists of ridges of its first poly: 2 of a surface, 4 of a
  /// volume. Returns how many.
  unsigned ridges_of(std::uint32_t f, std::uint32_t (&entries)[4]) const;
  /// The facet that continues f behind the ridge r, about which there are four polys.
  std::uint32_t opposite_at(std::uint32_t f, std::uint32_t r) const;
};

/// What is at a ridge.
struct ridge_shape {
  std::uint32_t valence = 0;  // polys
  bool on_boundary = false;
  bool is_manifold = true;  // the polys are one fan, and no facet has more than two
  bool is_regular() const { return valence == 0 || (is_manifold && valence == (on_boundary ? 2u : 4u)); }
};

/// Fans of polys about ridges, which facets with two polys connect. Regular are those of four polys that are closed,
/// and open ones of two.
struct ridge_fans {
  std::vector<ridge_shape> shapes;                       // by ridge
  std::vector<unsigned char> is_crossing, is_irregular;  // by place in poly_ridges(): whether the fan there is closed
                                                         // and regular, and whether it is not regular
  explicit ridge_fans(const cube_tables& t);

 private:
  std::vector<std::uint32_t> fan_;
  void find_fan(const cube_tables& t, std::uint32_t entry);
  bool walk(const cube_tables& t, std::uint32_t p, std::uint32_t f, std::uint32_t r);
};

/// Adds polys to t. The functions number their elements; edges and facets of surfaces have the same numbers.
/// Errors: invalid_mesh if a poly is not a quad or a hex.
template<class M, class Polys, class Vert, class Edge, class Facet>
void add_polys(const M& m, const Polys& all, const Vert& vert, const Edge& edge, const Facet& facet, cube_tables& t,
               const char* caller) {
  constexpr unsigned d = dimension_v<M>;
  for (const poly_t<M> p : all) {
    const auto corners = corners_by_place(m, p, caller);
    for (const vert_t<M>& v : corners) t.poly_verts.push_back(vert(v));
    const std::size_t first_edge = t.poly_edges.size(), first_facet = t.poly_facets.size();
    t.poly_edges.resize(first_edge + t.num_poly_edges());
    t.poly_facets.resize(first_facet + t.num_poly_facets());
    for (const edge_t<M> e : exactly<(d << (d - 1)), edge_t<M>>(m, p, adj_p2e(m, p), caller)) {
      const place_in_poly at = place_of_edge(m, p, corners, e, caller);
      t.poly_edges[first_edge + (at.axis << (d - 1)) + at.number] = edge(e);
    }
    for (const facet_t<M> f : exactly<2 * d, facet_t<M>>(m, p, adj_p2facet(m, p), caller)) {
      const place_in_poly at = place_of_facet(m, p, corners, f, caller);
      t.poly_facets[first_facet + 2 * at.axis + at.number] = facet(f);
    }
  }
}

/// Errors: invalid_mesh if a poly is not a quad or a hex.
template<class M>
cube_tables cube_tables_of(const M& m, const char* caller) {
  cube_tables t;
  t.dimension = dimension_v<M>;
  t.num_verts = num_verts(m), t.num_edges = num_edges(m), t.num_facets = num_facets(m);
  const auto vert = core::numbered(m, verts(m), vert_index_bound(m));
  const auto edge = core::numbered(m, edges(m), edge_index_bound(m));
  const auto facet = core::numbered(m, facets(m), facet_index_bound(m));
  t.poly_verts.reserve(num_polys(m) * t.num_corners());
  t.poly_edges.reserve(num_polys(m) * t.num_poly_edges());
  t.poly_facets.reserve(num_polys(m) * t.num_poly_facets());
  add_polys(
      m, polys(m), [&](const vert_t<M>& v) { return vert[index_of(m, v)]; },
      [&](const edge_t<M>& e) { return edge[index_of(m, e)]; },
      [&](const facet_t<M>& f) { return facet[index_of(m, f)]; }, t, caller);
  t.prepare();
  return t;
}

/// The elements of a range by their numbers.
template<class X, class R>
std::vector<X> by_number(const R& elements, std::size_t count) {
  std::vector<X> all;
  all.reserve(count);
  for (const X x : elements) all.push_back(x);
  return all;
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/layout/detail/cube_tables.ipp>
#endif
