// The triangles at an edge, as direct edits find them, and requests for the memory that these edits read and write; see triangle_edits.ipp.
#pragma once

#include <concino/mesh/surface_tables.hpp>

#include <new>
#include <utility>

namespace concino {

/// Edge k of a triangle, and what is behind it.
template<unsigned Arity, class Lists>
struct surface_tables<Arity, Lists>::outer_edge {
  edge_id e;
  detail::encoded_neighbour outside;

  outer_edge() = default;
  [[gnu::always_inline]] inline outer_edge(const surface_tables& t, poly_id p, std::uint32_t k) : e(t.facet_adjacency_.facets(p)[k]), outside(t.facet_adjacency_.neighbour(p, k)) {}
  /// Whether the triangle has one neighbour here, which is not behind another one of its edges, or none.
  bool is_regular() const { return outside.is_none() || outside.is_first_occurrence(); }
};

/// Which of the other edges of a triangle at the edge ab get another poly. Nothing is read or written for those that keep theirs.
template<unsigned Arity, class Lists>
struct surface_tables<Arity, Lists>::changing_edges {
  bool ca, bc;
};

/// A triangle at the edge ab, with its third vert c. `at_edge`, `at_a`, `at_b`: the numbers of the edges ab, ca, bc; `corner_a`, `corner_b`: of the corners.
template<unsigned Arity, class Lists>
struct surface_tables<Arity, Lists>::side_of_edge {
  poly_id p;
  vert_id c;
  std::uint32_t at_edge, at_a, at_b, corner_a, corner_b;
  outer_edge ca, bc;

  static std::uint32_t next(std::uint32_t k) { return k == 2 ? 0 : k + 1; }
  side_of_edge() = default;
  [[gnu::always_inline]] inline side_of_edge(const surface_tables& t, poly_id poly, std::uint32_t k, vert_id a, changing_edges changing) : p(poly), at_edge(k) {
    const std::uint32_t second = next(at_edge), third = next(second);
    const vert_id* const v = t.p2v_.begin(p.raw());
    c = v[third];
    const bool starts_at_a = v[at_edge] == a;
    corner_a = starts_at_a ? at_edge : second, corner_b = starts_at_a ? second : at_edge;
    at_a = starts_at_a ? third : second, at_b = starts_at_a ? second : third;
    ca = outer_edge(t, p, at_a), bc = outer_edge(t, p, at_b);
    t.prefetch_vert(c);
    if (changing.ca) t.facet_adjacency_.prefetch_outside(ca.e, ca.outside);
    if (changing.bc) t.facet_adjacency_.prefetch_outside(bc.e, bc.outside);
  }
  bool is_regular() const { return ca.is_regular() && bc.is_regular(); }
};

/// The second poly of each edge that has two, and any one for the others.
template<unsigned Arity, class Lists>
core::flat_array<poly_id> surface_tables<Arity, Lists>::second_polys() const {
  core::flat_array<poly_id> all(edges_.bound(), poly_id{0});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const edge_id e{i};
    if (!facet_adjacency_.is_owned(e)) continue;
    const auto [p, k] = facet_adjacency_.owner(e);
    if (const detail::encoded_neighbour x = facet_adjacency_.neighbour(poly_id{p}, k); x.is_first_occurrence()) all[i] = poly_id{x.poly()};
  }
  return all;
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::expect_second_poly(edge_id e, poly_id p) {
  if (e.raw() < probable_second_poly_.size()) probable_second_poly_[e.raw()] = p;
}

/// Makes the lists of verts editable.
template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::make_growable() {
  incident_.make_growable();
  if constexpr (Arity == 3)
    if (probable_second_poly_.size() == 0) [[unlikely]] probable_second_poly_ = second_polys();
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::prefetch_vert(vert_id v) const {
  incident_.prefetch_place(v), incident_.prefetch_slot(v);
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::prefetch_lists(vert_id v) const {
  incident_.prefetch_edges(v), incident_.prefetch_polys(v);
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::prefetch_poly(poly_id p) const {
  __builtin_prefetch(p2v_.begin(p.raw()), 1);
  facet_adjacency_.prefetch_poly(p);
}

/// Whether a and b have an edge. The list of a is searched, unless it is the longer one of two that are not short.
template<unsigned Arity, class Lists>
template<class Incident>
bool surface_tables<Arity, Lists>::have_common_edge(const Incident& at, vert_id a, vert_id b) {
  if (at.num_edges(a) > longest_fan && at.num_edges(b) < at.num_edges(a)) std::swap(a, b);
  return at.find(a, b) < at.num_edges(a);
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::set_ends(edge_id e, vert_id a, vert_id b) {
  vert_id* const ends = e2v_.begin(e.raw());
  ends[0] = std::min(a, b), ends[1] = std::max(a, b);
}

/// The triangles at e, which has the ends a and b; returns 0 if these edits leave it to rewire. Requests what edits of e use, level by level.
template<unsigned Arity, class Lists>
[[gnu::always_inline]] inline std::uint32_t surface_tables<Arity, Lists>::find_triangles(edge_id e, vert_id a, vert_id b, const changing_edges (&changing)[2],
                                                                                         side_of_edge* two) const {
  if (!facet_adjacency_.is_owned(e)) return 0;
  const auto [first, k] = facet_adjacency_.owner(e);
  const poly_id p{first};
  if (e.raw() < probable_second_poly_.size()) prefetch_poly(probable_second_poly_[e.raw()]);
  prefetch_poly(p);
  prefetch_vert(a), prefetch_vert(b);
  const detail::encoded_neighbour behind = facet_adjacency_.neighbour(p, k);
  if (!behind.is_none() && !behind.is_first_occurrence()) return 0;
  if (!behind.is_none()) prefetch_poly(poly_id{behind.poly()});
  ::new (static_cast<void*>(two)) side_of_edge(*this, p, k, a, changing[0]);  // in its place: a copy would be read before it has been written, and std::construct_at is not inlined
  if (!two[0].is_regular()) return 0;
  if (behind.is_none()) return 1;
  const poly_id q{behind.poly()};
  ::new (static_cast<void*>(two + 1)) side_of_edge(*this, q, facet_adjacency_.position_of(q, e), a, changing[1]);
  return two[1].is_regular() ? 2 : 0;
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::prefetch_edit(edge_id e, unsigned round) const
  requires(Arity == 3)
{
  if (!edges_.contains(e)) return;
  const bool has_probable = e.raw() < probable_second_poly_.size();
  if (round == 0) {
    prefetch(e);
    if (has_probable) __builtin_prefetch(probable_second_poly_.data() + e.raw());
    return;
  }
  const vert_id a = e2v_[e.raw()][0], b = e2v_[e.raw()][1];
  if (round == 1) {
    if (!facet_adjacency_.is_owned(e)) return;
    prefetch_poly(poly_id{facet_adjacency_.owner(e).poly});
    if (has_probable) prefetch_poly(probable_second_poly_[e.raw()]);
    prefetch_vert(a), prefetch_vert(b);
    return;
  }
  side_of_edge two[2];
  find_triangles(e, a, b, {{true, true}, {true, true}}, two);
}

}  // namespace concino
