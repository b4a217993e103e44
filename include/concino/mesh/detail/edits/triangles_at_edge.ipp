// The triangles at an edge, as edits of triangles find them; see triangle_edits.ipp.
#pragma once

#include <concino/mesh/surface_tables.hpp>

#include <utility>

namespace concino {

/// Edge k of a triangle, and what is behind it.
template<unsigned Arity, class Lists>
struct surface_tables<Arity, Lists>::outer_edge {
  edge_id e;
  detail::encoded_neighbour outside;

  outer_edge() = default;
  outer_edge(const surface_tables& t, poly_id p, std::uint32_t k)
      : e(t.facet_adjacency_.facets(p)[k]), outside(t.facet_adjacency_.neighbour(p, k)) {}
  /// Whether the triangle has one neighbour here, which is not behind another one of its edges, or none.
  bool is_regular() const { return outside.is_none() || outside.is_first_occurrence(); }
};

/// A triangle at the edge ab, with its third vert c. `at_edge`, `at_a`, `at_b`: the numbers of the edges ab, ca, bc;
/// `corner_a`, `corner_b`: of the corners.
template<unsigned Arity, class Lists>
struct surface_tables<Arity, Lists>::side_of_edge {
  poly_id p;
  vert_id c;
  std::uint32_t at_edge, at_a, at_b, corner_a, corner_b;
  outer_edge ca, bc;

  static std::uint32_t next(std::uint32_t k) { return k == 2 ? 0 : k + 1; }
  side_of_edge() = default;
  side_of_edge(const surface_tables& t, poly_id poly, std::uint32_t k, vert_id a) : p(poly), at_edge(k) {
    const std::uint32_t second = next(at_edge), third = next(second);
    const vert_id* const v = t.p2v_.begin(p.raw());
    c = v[third];
    const bool starts_at_a = v[at_edge] == a;
    corner_a = starts_at_a ? at_edge : second, corner_b = starts_at_a ? second : at_edge;
    at_a = starts_at_a ? third : second, at_b = starts_at_a ? second : third;
    ca = outer_edge(t, p, at_a), bc = outer_edge(t, p, at_b);
  }
  bool is_regular() const { return ca.is_regular() && bc.is_regular(); }
};

/// Whether a and b have an edge. The list of a is searched, unless it is the longer one of two that are not short.
template<unsigned Arity, class Lists>
bool surface_tables<Arity, Lists>::have_common_edge(vert_id a, vert_id b) const {
  if (incident_.num_edges(a) > longest_fan && incident_.num_edges(b) < incident_.num_edges(a)) std::swap(a, b);
  return incident_.find(a, b) < incident_.num_edges(a);
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::set_ends(edge_id e, vert_id a, vert_id b) {
  vert_id* const ends = e2v_.begin(e.raw());
  ends[0] = std::min(a, b), ends[1] = std::max(a, b);
}

/// The triangles at e, whose first end is a; returns 0 if these edits leave it to rewire.
template<unsigned Arity, class Lists>
std::uint32_t surface_tables<Arity, Lists>::find_triangles(edge_id e, vert_id a, side_of_edge* two) const {
  if (!facet_adjacency_.is_owned(e)) return 0;
  const auto [first, k] = facet_adjacency_.owner(e);
  const detail::encoded_neighbour behind = facet_adjacency_.neighbour(poly_id{first}, k);
  if (!behind.is_none() && !behind.is_first_occurrence()) return 0;
  two[0] = side_of_edge(*this, poly_id{first}, k, a);
  if (!two[0].is_regular()) return 0;
  if (behind.is_none()) return 1;
  const poly_id q{behind.poly()};
  two[1] = side_of_edge(*this, q, facet_adjacency_.position_of(q, e), a);
  return two[1].is_regular() ? 2 : 0;
}

}  // namespace concino
