// Splits, flips and collapses of an edge of triangles by direct changes of the tables; see surface_tables.hpp. They
// change what rewire would change, in the same order, but know the edit, so that nothing is searched, numbered or
// compared. Where a triangle of the edit has a non-manifold edge or a neighbour behind two of its edges, they leave the
// edit to rewire.
#pragma once

#include <concino/mesh/detail/edits/cavity_changes.hpp>
#include <concino/mesh/detail/edits/triangles_at_edge.ipp>
#include <concino/mesh/surface_tables.hpp>

namespace concino {

/// Allocates the memory for the split of an edge with n triangles.
template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::reserve_split(const side_of_edge* s, std::uint32_t n)
  requires(Arity == 3)
{
  incident_.make_growable();
  for (std::uint32_t i = 0; i < n; ++i) incident_.reserve_at(s[i].c, 1, 1);
  incident_.reserve_verts(1, n + 2);
  p2v_.reserve_rows(n), e2v_.reserve_rows(n + 1);
  facet_adjacency_.reserve_polys(n, 3 * n, n + 1);
  verts_.reserve(1), edges_.reserve(n + 1), polys_.reserve(n);
}

/// The edges at the new vert x, which has no lists yet, when e is split. to[i] leads from x to the third vert of
/// triangle i, to[n] to b.
template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::split_edges(edge_id e, vert_id x, const side_of_edge* s, std::uint32_t n,
                                               edge_id* to) requires(Arity == 3) {
  const vert_id a = e2v_[e.raw()][0], b = e2v_[e.raw()][1];
  const bool edge_is_first = s[0].at_edge < s[0].at_b;
  incident_.set_other_end(a, e, x);
  set_ends(e, a, x);
  incident_.replace_by_last(b, e);
  if (edge_is_first) incident_.push(x, a, e);
  for (std::uint32_t i = 0; i <= n; ++i) {
    const vert_id v = i < n ? s[i].c : b, ends[] = {v, x};
    to[i] = edges_.add();
    e2v_.add_row(ends, ends + 2);
    facet_adjacency_.add_facet();
    incident_.push(v, x, to[i]), incident_.push(x, v, to[i]);
    if (i == 0 && !edge_is_first) incident_.push(x, a, e);
  }
}

template<unsigned Arity, class Lists>
vert_id surface_tables<Arity, Lists>::split_edge(edge_id e)
  requires(Arity == 3)
{
  const vert_id a = e2v_[e.raw()][0], b = e2v_[e.raw()][1];
  side_of_edge s[2];
  const std::uint32_t n = find_triangles(e, a, s);
  if (n == 0) return {};
  reserve_split(s, n);

  const vert_id x = verts_.add();
  incident_.add_vert(n + 2);
  poly_id q[2];
  for (std::uint32_t i = 0; i < n; ++i) q[i] = polys_.add(), incident_.remove(b, s[i].p), incident_.push(x, s[i].p);
  for (std::uint32_t i = 0; i < n; ++i)
    for (const vert_id v : {b, s[i].c, x}) incident_.push(v, q[i]);
  edge_id to[3];
  split_edges(e, x, s, n, to);
  for (std::uint32_t i = 0; i < n; ++i) {
    const poly_id p = s[i].p;
    p2v_.stage_row(p2v_.begin(p.raw()), 3);
    p2v_.commit_row(3);
    facet_adjacency_.add_poly(3);
    p2v_.begin(p.raw())[s[i].corner_b] = x;
    p2v_.begin(q[i].raw())[s[i].corner_a] = x;
    facet_adjacency_.put(q[i], s[i].at_b, s[i].bc.e, s[i].bc.outside);
    facet_adjacency_.put_between(p, s[i].at_b, q[i], s[i].at_a, to[i]);
  }
  if (n == 2) {
    facet_adjacency_.put_between(s[0].p, s[0].at_edge, s[1].p, s[1].at_edge, e);
    facet_adjacency_.put_between(q[0], s[0].at_edge, q[1], s[1].at_edge, to[n]);
  } else {
    facet_adjacency_.put(s[0].p, s[0].at_edge, e, {});
    facet_adjacency_.put(q[0], s[0].at_edge, to[n], {});
  }
  return x;
}

template<unsigned Arity, class Lists>
bool surface_tables<Arity, Lists>::flip_edge(edge_id e)
  requires(Arity == 3)
{
  const vert_id a = e2v_[e.raw()][0], b = e2v_[e.raw()][1];
  side_of_edge s[2];
  if (find_triangles(e, a, s) != 2) return false;
  const auto runs_to_b = [](const side_of_edge& x) { return x.corner_a == x.at_edge; };
  if (runs_to_b(s[0]) == runs_to_b(s[1])) return false;
  const poly_id p = s[0].p, q = s[1].p;
  const vert_id c = s[0].c, d = s[1].c;
  if (have_common_edge(c, d)) return false;
  incident_.make_growable();
  for (const vert_id v : {c, d}) incident_.reserve_at(v, 1, 1);

  incident_.remove(a, q), incident_.replace_by_last(a, e);
  incident_.remove(b, p), incident_.replace_by_last(b, e);
  incident_.push(c, q), incident_.push(c, d, e);
  incident_.push(d, p), incident_.push(d, c, e);
  p2v_.begin(p.raw())[s[0].corner_b] = d;
  p2v_.begin(q.raw())[s[1].corner_a] = c;
  set_ends(e, c, d);
  facet_adjacency_.put_between(p, s[0].at_b, q, s[1].at_a, e);
  facet_adjacency_.put(p, s[0].at_edge, s[1].ca.e, s[1].ca.outside);
  facet_adjacency_.put(q, s[1].at_edge, s[0].bc.e, s[0].bc.outside);
  return true;
}

/// Whether the polys at b are one closed fan of at least four regular triangles that contains both sides, so that the
/// link of b is a circle.
template<unsigned Arity, class Lists>
bool surface_tables<Arity, Lists>::is_closed_fan(vert_id b, const side_of_edge* s) const {
  const std::uint32_t n = incident_.num_polys(b);
  if (n < 4) return false;
  poly_id p = s[0].p;
  std::uint32_t k = s[0].at_b, visited = 0;
  do {
    const detail::encoded_neighbour x = facet_adjacency_.neighbour(p, k);
    if (++visited > n || x.is_none()) return false;
    const edge_id e = facet_adjacency_.facets(p)[k];
    p = poly_id{x.poly()};
    if (facet_adjacency_.is_marked(p.raw())) return false;
    const std::uint32_t j = facet_adjacency_.position_of(p, e), next = side_of_edge::next(j);
    k = p2v_.begin(p.raw())[j] == b ? side_of_edge::next(next) : next;
  } while (p != s[0].p);
  return visited == n;
}

template<unsigned Arity, class Lists>
bool surface_tables<Arity, Lists>::collapse_edge(edge_id e)
  requires(Arity == 3)
{
  const vert_id a = e2v_[e.raw()][0], b = e2v_[e.raw()][1];
  side_of_edge s[2];
  if (incident_.num_edges(b) > longest_fan || find_triangles(e, a, s) != 2) return false;
  for (const vert_id x : incident_.verts(b))  // the link condition: both links have no other common verts
    if (x != a && x != s[0].c && x != s[1].c && have_common_edge(a, x)) return false;
  if (incident_.num_edges(b) != incident_.num_polys(b) || !is_closed_fan(b, s)) return false;
  const std::uint32_t more = incident_.num_polys(b) - 4;
  incident_.make_growable();
  incident_.reserve_at(a, more, more);
  verts_.reserve_change(1, 0), edges_.reserve_change(3, 0), polys_.reserve_change(2, 0);

  const outer_edge kept[] = {s[0].ca, s[1].ca}, lost[] = {s[0].bc, s[1].bc};
  incident_.replace_by_last(a, e);
  edges_.remove(e);
  for (std::uint32_t i = 0; i < 2; ++i) {
    incident_.remove(a, s[i].p), incident_.remove(s[i].c, s[i].p);
    incident_.replace_by_last(s[i].c, lost[i].e);
    edges_.remove(lost[i].e);
    polys_.remove(s[i].p);
  }
  for (const poly_id p : incident_.polys(b)) {
    if (p == s[0].p || p == s[1].p) continue;
    vert_id* const v = p2v_.begin(p.raw());
    const std::uint32_t at_b = v[0] == b ? 0 : v[1] == b ? 1 : 2;
    v[at_b] = a;
    incident_.push(a, p);
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (k == side_of_edge::next(at_b)) continue;  // it keeps its polys
      const outer_edge x(*this, p, k);
      if (x.e == lost[0].e) facet_adjacency_.put(p, k, kept[0].e, kept[0].outside);
      else if (x.e == lost[1].e) facet_adjacency_.put(p, k, kept[1].e, kept[1].outside);
      else move_end(x.e, b, a, p, k);
    }
  }
  incident_.clear(b);
  verts_.remove(b);
  return true;
}

/// Makes an edge of `from`, which is edge k of p and of another poly, one of `to`, once.
template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::move_end(edge_id e, vert_id from, vert_id to, poly_id p, std::uint32_t k) {
  const vert_id* const ends = e2v_.begin(e.raw());
  if (ends[0] != from && ends[1] != from) return;
  const vert_id other = ends[0] == from ? ends[1] : ends[0];
  set_ends(e, to, other);
  incident_.set_other_end(other, e, to);
  incident_.push(to, other, e);
  facet_adjacency_.set_first(e, p, k);
}

}  // namespace concino
