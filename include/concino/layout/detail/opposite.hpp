// What lies opposite in a quad or a hex: the opposite facet, and the edges that are parallel to an edge.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>

#include <array>
#include <cstddef>

namespace concino {

namespace requirement {

/// A surface whose polys are or may be quads, or a volume of hexes. That those of a surface without fixed arity are
/// quads is checked when they are met.
template<class M> concept may_be_quads = SurfaceMesh<M> && (arity_v<M> == 4 || arity_v<M> == 0);
template<class M> concept may_be_quads_or_hexes = may_be_quads<M> || HexMesh<M>;

}  // namespace requirement

namespace detail {

[[noreturn, gnu::cold]] inline void throw_no_quad_or_hex(std::size_t poly, bool is_volume, const char* caller) {
  core::throw_joined<invalid_mesh>({caller, ": poly ", poly, " is not a ", is_volume ? "hex" : "quad",
                                    "; all polys of the mesh have to be ", is_volume ? "hexes" : "quads"});
}

template<class M, class X>
void check_member(const M& m, const X& x, const char* caller, const char* kind) {
  if (!contains(m, x))
    core::throw_joined<invalid_mesh>(
        {caller, ": ", kind, " ", index_of(m, x), " is not ", *kind == 'e' ? "an " : "a ", kind, " of the mesh"});
}

/// The elements of a range that has n.
/// Errors: invalid_mesh if it has not.
template<std::size_t n, class X, class M, class R>
std::array<X, n> exactly(const M& m, const poly_t<M>& p, const R& range, const char* caller) {
  std::array<X, n> all;
  std::size_t count = 0;
  for (const X x : range) {
    if (count == n) throw_no_quad_or_hex(index_of(m, p), dimension_v<M> == 3, caller);
    all[count++] = x;
  }
  if (count != n) throw_no_quad_or_hex(index_of(m, p), dimension_v<M> == 3, caller);
  return all;
}

/// The corners of a poly in the order of their places: bit 0 of the index is the place along the first axis of the
/// poly, and so on. adj_p2v has corner_places[k] as its k-th.
inline constexpr std::array<unsigned char, 8> corner_places = {0, 1, 3, 2, 4, 5, 7, 6};

template<class M>
auto corners_by_place(const M& m, const poly_t<M>& p, const char* caller) {
  constexpr std::size_t n = dimension_v<M> == 2 ? 4 : 8;
  const auto in_order = exactly<n, vert_t<M>>(m, p, adj_p2v(m, p), caller);
  std::array<vert_t<M>, n> corners;
  for (std::size_t k = 0; k < n; ++k) corners[corner_places[k]] = in_order[k];
  return corners;
}

/// The place of v in the corners of p.
template<class M, class Corners>
unsigned place_of(const M& m, const poly_t<M>& p, const Corners& corners, const vert_t<M>& v, const char* caller) {
  for (unsigned k = 0; k < corners.size(); ++k)
    if (corners[k] == v) return k;
  throw_no_quad_or_hex(index_of(m, p), dimension_v<M> == 3, caller);
}

/// An edge or face of a poly: the axis along which, or the one and only axis to which, it runs; its number among those
/// of this axis. Edges are numbered by the places of their first end without the bit of the axis; faces lie at the
/// first or second end of the axis.
struct place_in_poly {
  unsigned axis, number;
};

template<class M, class Corners>
place_in_poly place_of_edge(const M& m, const poly_t<M>& p, const Corners& corners, const edge_t<M>& e,
                            const char* caller) {
  const auto [a, b] = end_verts(m, e);
  const unsigned x = place_of(m, p, corners, a, caller), y = place_of(m, p, corners, b, caller);
  for (unsigned axis = 0; axis < dimension_v<M>; ++axis)
    if ((x ^ y) == 1u << axis) {
      const unsigned first = x & y, low = (1u << axis) - 1;
      return {axis, (first & low) | ((first >> 1) & ~low)};
    }
  throw_no_quad_or_hex(index_of(m, p), dimension_v<M> == 3, caller);
}

template<class M, class Corners>
place_in_poly place_of_facet(const M& m, const poly_t<M>& p, const Corners& corners, const facet_t<M>& f,
                             const char* caller) {
  unsigned in_all = 7, in_some = 0;
  for (const vert_t<M> v : adj_facet2v(m, f)) {
    const unsigned k = place_of(m, p, corners, v, caller);
    in_all &= k, in_some |= k;
  }
  for (unsigned axis = 0; axis < dimension_v<M>; ++axis) {
    if (in_all == 1u << axis) return {axis, 1};
    if (in_all == 0 && in_some == (corners.size() - 1 - (1u << axis))) return {axis, 0};
  }
  throw_no_quad_or_hex(index_of(m, p), dimension_v<M> == 3, caller);
}

/// The facet of p opposite to f.
template<class M>
facet_t<M> opposite_facet(const M& m, const poly_t<M>& p, const facet_t<M>& f, const char* caller) {
  const auto corners = corners_by_place(m, p, caller);
  const place_in_poly at = place_of_facet(m, p, corners, f, caller);
  for (const facet_t<M> g : exactly<2 * dimension_v<M>, facet_t<M>>(m, p, adj_p2facet(m, p), caller)) {
    const place_in_poly other = place_of_facet(m, p, corners, g, caller);
    if (other.axis == at.axis && other.number != at.number) return g;
  }
  throw_no_quad_or_hex(index_of(m, p), dimension_v<M> == 3, caller);
}

/// The four edges of a hex that are parallel to e, e among them.
template<HexMesh M>
std::array<edge_t<M>, 4> parallel_edges(const M& m, const poly_t<M>& p, const edge_t<M>& e, const char* caller) {
  const auto corners = corners_by_place(m, p, caller);
  const unsigned axis = place_of_edge(m, p, corners, e, caller).axis;
  std::array<edge_t<M>, 4> parallel;
  for (const edge_t<M> x : exactly<12, edge_t<M>>(m, p, adj_p2e(m, p), caller))
    if (const place_in_poly at = place_of_edge(m, p, corners, x, caller); at.axis == axis) parallel[at.number] = x;
  return parallel;
}

}  // namespace detail

}  // namespace concino
