// Splits, flips and collapses of an edge of triangles by direct changes of the tables; see surface_tables.hpp. They change what rewire would change, in the
// same order, but know the edit, so that nothing is searched, numbered or compared. Where a triangle of the edit has a non-manifold edge or a neighbour behind
// two of its edges, they leave the edit to rewire.
#pragma once

#include <concino/mesh/detail/cavity_changes.hpp>
#include <concino/mesh/surface_tables.hpp>

namespace concino {

/// A triangle at the edge ab, with its third vert c. `at_edge`, `at_a`, `at_b`: the numbers of the edges ab, ca, bc; `corner_a`, `corner_b`: of the corners.
template<unsigned Arity, class Lists>
struct surface_tables<Arity, Lists>::side_of_edge {
  poly_id p;
  vert_id c;
  std::uint32_t at_edge, at_a, at_b, corner_a, corner_b;

  static std::uint32_t next(std::uint32_t k) { return k == 2 ? 0 : k + 1; }
  side_of_edge() = default;
  side_of_edge(const surface_tables& t, poly_id poly, edge_id e, vert_id a) : p(poly), at_edge(t.facet_adjacency_.position_of(poly, e)) {
    const std::uint32_t second = next(at_edge), third = next(second);
    const vert_id* const v = t.p2v_.begin(p.raw());
    c = v[third];
    const bool starts_at_a = v[at_edge] == a;
    corner_a = starts_at_a ? at_edge : second, corner_b = starts_at_a ? second : at_edge;
    at_a = starts_at_a ? third : second, at_b = starts_at_a ? second : third;
  }
};

/// Edge k of a triangle, and what is behind it.
template<unsigned Arity, class Lists>
struct surface_tables<Arity, Lists>::outer_edge {
  edge_id e;
  detail::encoded_neighbour outside;

  outer_edge(const surface_tables& t, poly_id p, std::uint32_t k) : e(t.facet_adjacency_.facets(p)[k]), outside(t.facet_adjacency_.neighbour(p, k)) {}
};

template<unsigned Arity, class Lists>
bool surface_tables<Arity, Lists>::have_common_edge(vert_id a, vert_id b) const {
  if (v2v_.length(b.raw()) < v2v_.length(a.raw())) std::swap(a, b);
  for (const vert_id v : v2v_[a.raw()])
    if (v == b) return true;
  return false;
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::remove_edge_at(vert_id v, edge_id e) {
  const std::size_t k = v2e_.position(v.raw(), e);
  v2v_.remove_at(v.raw(), k), v2e_.remove_at(v.raw(), k);
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::push_edge_at(vert_id v, vert_id other, edge_id e) {
  v2v_.push_reserved(v.raw(), other), v2e_.push_reserved(v.raw(), e);
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::set_ends(edge_id e, vert_id a, vert_id b) {
  vert_id* const ends = e2v_.begin(e.raw());
  ends[0] = std::min(a, b), ends[1] = std::max(a, b);
}

template<unsigned Arity, class Lists>
std::uint32_t surface_tables<Arity, Lists>::find_triangles(edge_id e, vert_id a, side_of_edge* two) const {
  const detail::polys_of_facet at = adj_e2p(e);
  const auto n = static_cast<std::uint32_t>(at.size());
  if (n == 0 || n > 2) return 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    two[i] = side_of_edge(*this, at[i], e, a);
    if (facet_adjacency_.is_marked(two[i].p.raw())) return 0;
  }
  return n;
}

template<unsigned Arity, class Lists>
vert_id surface_tables<Arity, Lists>::split_edge(edge_id e)
  requires(Arity == 3)
{
  const vert_id a = e2v_[e.raw()][0], b = e2v_[e.raw()][1];
  side_of_edge s[2];
  const std::uint32_t n = find_triangles(e, a, s);
  if (n == 0) return {};
  for (std::uint32_t i = 0; i < n; ++i) {
    detail::reserve_edges_at(v2v_, v2e_, s[i].c, 1);
    v2p_.reserve_in_row(s[i].c.raw(), 1);
  }
  v2v_.reserve_rows(1, n + 2), v2e_.reserve_rows(1, n + 2), v2p_.reserve_rows(1, 2 * n);
  p2v_.reserve_rows(n), e2v_.reserve_rows(n + 1);
  facet_adjacency_.reserve_polys(n, 3 * n, n + 1);
  verts_.reserve(1), edges_.reserve(n + 1), polys_.reserve(n);

  const vert_id x = verts_.add();
  detail::add_lists_of_vert(v2v_, v2e_, v2p_, {0, 2 * n, 0, n + 2});
  poly_id q[2];
  for (std::uint32_t i = 0; i < n; ++i) q[i] = polys_.add(), v2p_.remove(b.raw(), s[i].p), v2p_.push_reserved(x.raw(), s[i].p);
  for (std::uint32_t i = 0; i < n; ++i)
    for (const vert_id v : {b, s[i].c, x}) v2p_.push_reserved(v.raw(), q[i]);

  const std::size_t k = v2e_.position(a.raw(), e);
  v2v_.begin(a.raw())[k] = x;
  set_ends(e, a, x);
  remove_edge_at(b, e);
  const bool edge_is_first = s[0].at_edge < s[0].at_b;
  if (edge_is_first) push_edge_at(x, a, e);
  edge_id to[3];  // from x to the third verts, and to b
  for (std::uint32_t i = 0; i <= n; ++i) {
    const vert_id v = i < n ? s[i].c : b, ends[] = {v, x};
    to[i] = edges_.add();
    e2v_.add_row(ends, ends + 2);
    facet_adjacency_.add_facet();
    push_edge_at(v, x, to[i]), push_edge_at(x, v, to[i]);
    if (i == 0 && !edge_is_first) push_edge_at(x, a, e);
  }

  for (std::uint32_t i = 0; i < n; ++i) {
    const poly_id p = s[i].p;
    const outer_edge at_a(*this, p, s[i].at_a), at_b(*this, p, s[i].at_b);
    p2v_.stage_row(p2v_.begin(p.raw()), 3);
    p2v_.commit_row(3);
    facet_adjacency_.add_poly(3);
    p2v_.begin(p.raw())[s[i].corner_b] = x;
    p2v_.begin(q[i].raw())[s[i].corner_a] = x;
    facet_adjacency_.put(p, s[i].at_a, at_a.e, at_a.outside);
    facet_adjacency_.put(q[i], s[i].at_b, at_b.e, at_b.outside);
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
direct_edit surface_tables<Arity, Lists>::flip_edge(edge_id e)
  requires(Arity == 3)
{
  const vert_id a = e2v_[e.raw()][0], b = e2v_[e.raw()][1];
  side_of_edge s[2];
  if (find_triangles(e, a, s) != 2) return direct_edit::left_to_rewire;
  const auto runs_to_b = [](const side_of_edge& x) { return x.corner_a == x.at_edge; };
  if (runs_to_b(s[0]) == runs_to_b(s[1])) return direct_edit::left_to_rewire;
  if (have_common_edge(s[0].c, s[1].c)) return direct_edit::refused;
  for (const side_of_edge& x : s) {
    detail::reserve_edges_at(v2v_, v2e_, x.c, 1);
    v2p_.reserve_in_row(x.c.raw(), 1);
  }

  const poly_id p = s[0].p, q = s[1].p;
  v2p_.remove(b.raw(), p), v2p_.remove(a.raw(), q);
  v2p_.push_reserved(s[1].c.raw(), p), v2p_.push_reserved(s[0].c.raw(), q);
  remove_edge_at(a, e), remove_edge_at(b, e);
  push_edge_at(s[0].c, s[1].c, e), push_edge_at(s[1].c, s[0].c, e);
  set_ends(e, s[0].c, s[1].c);
  const outer_edge p_a(*this, p, s[0].at_a), p_b(*this, p, s[0].at_b), q_a(*this, q, s[1].at_a), q_b(*this, q, s[1].at_b);
  p2v_.begin(p.raw())[s[0].corner_b] = s[1].c;
  p2v_.begin(q.raw())[s[1].corner_a] = s[0].c;
  facet_adjacency_.put(p, s[0].at_edge, q_a.e, q_a.outside);
  facet_adjacency_.put(p, s[0].at_a, p_a.e, p_a.outside);
  facet_adjacency_.put(q, s[1].at_edge, p_b.e, p_b.outside);
  facet_adjacency_.put(q, s[1].at_b, q_b.e, q_b.outside);
  facet_adjacency_.put_between(p, s[0].at_b, q, s[1].at_a, e);
  return direct_edit::done;
}

/// Whether the polys at b are one closed fan of at least four regular triangles that contains both sides, so that the link of b is a circle.
template<unsigned Arity, class Lists>
bool surface_tables<Arity, Lists>::is_closed_fan(vert_id b, const side_of_edge* s) const {
  const std::uint32_t n = v2p_.length(b.raw());
  if (n < 4) return false;
  poly_id p = s[0].p;
  std::uint32_t k = s[0].at_b, met = 0;
  do {
    const detail::encoded_neighbour x = facet_adjacency_.neighbour(p, k);
    if (++met > n || x.is_none()) return false;
    const edge_id e = facet_adjacency_.facets(p)[k];
    p = poly_id{x.poly()};
    if (facet_adjacency_.is_marked(p.raw())) return false;
    const std::uint32_t j = facet_adjacency_.position_of(p, e), next = side_of_edge::next(j);
    k = p2v_.begin(p.raw())[j] == b ? side_of_edge::next(next) : next;
  } while (p != s[0].p);
  return met == n;
}

template<unsigned Arity, class Lists>
direct_edit surface_tables<Arity, Lists>::collapse_edge(edge_id e)
  requires(Arity == 3)
{
  const vert_id a = e2v_[e.raw()][0], b = e2v_[e.raw()][1];
  side_of_edge s[2];
  if (v2v_.length(b.raw()) > longest_fan || find_triangles(e, a, s) != 2) return direct_edit::left_to_rewire;
  for (const vert_id x : v2v_[b.raw()])  // the link condition: both links have no other common verts
    if (x != a && x != s[0].c && x != s[1].c && have_common_edge(x, a)) return direct_edit::refused;
  if (v2v_.length(b.raw()) != v2p_.length(b.raw()) || !is_closed_fan(b, s)) return direct_edit::left_to_rewire;
  const std::uint32_t more = v2p_.length(b.raw()) - 4;
  v2v_.reserve_in_row(a.raw(), more), v2e_.reserve_in_row(a.raw(), more), v2p_.reserve_in_row(a.raw(), more);
  verts_.reserve_change(1, 0), edges_.reserve_change(3, 0), polys_.reserve_change(2, 0);

  const outer_edge kept[] = {{*this, s[0].p, s[0].at_a}, {*this, s[1].p, s[1].at_a}}, lost[] = {{*this, s[0].p, s[0].at_b}, {*this, s[1].p, s[1].at_b}};
  remove_edge_at(a, e);
  edges_.remove(e);
  for (std::uint32_t i = 0; i < 2; ++i) {
    v2p_.remove(a.raw(), s[i].p), v2p_.remove(s[i].c.raw(), s[i].p);
    remove_edge_at(s[i].c, lost[i].e);
    edges_.remove(lost[i].e);
    polys_.remove(s[i].p);
  }
  for (const poly_id p : v2p_[b.raw()]) {
    if (p == s[0].p || p == s[1].p) continue;
    vert_id* const v = p2v_.begin(p.raw());
    const std::uint32_t at_b = v[0] == b ? 0 : v[1] == b ? 1 : 2;
    v[at_b] = a;
    v2p_.push_reserved(a.raw(), p);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const outer_edge x(*this, p, k);
      if (k == side_of_edge::next(at_b)) facet_adjacency_.put(p, k, x.e, x.outside);
      else if (x.e == lost[0].e) facet_adjacency_.put(p, k, kept[0].e, kept[0].outside);
      else if (x.e == lost[1].e) facet_adjacency_.put(p, k, kept[1].e, kept[1].outside);
      else move_end(x.e, b, a, p, k);
    }
  }
  v2v_.clear_row(b.raw()), v2e_.clear_row(b.raw()), v2p_.clear_row(b.raw());
  verts_.remove(b);
  return direct_edit::done;
}

/// Makes an edge of `from`, which is edge k of p and of another poly, one of `to`, once.
template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::move_end(edge_id e, vert_id from, vert_id to, poly_id p, std::uint32_t k) {
  const vert_id* const ends = e2v_.begin(e.raw());
  if (ends[0] != from && ends[1] != from) return;
  const vert_id other = ends[0] == from ? ends[1] : ends[0];
  set_ends(e, to, other);
  v2v_.begin(other.raw())[v2e_.position(other.raw(), e)] = to;
  push_edge_at(to, other, e);
  facet_adjacency_.set_first(e, p, k);
}

}  // namespace concino
