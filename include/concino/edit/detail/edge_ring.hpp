// The cavity of a flip of an edge that three or four tets surround.
#pragma once

#include <concino/edit/detail/facet_flip.hpp>

namespace concino::detail {

inline constexpr permission not_three_or_four{refusal::wrong_number,
                                              "the edge is not surrounded by three or four tets"};
inline constexpr permission face_exists{refusal::same_verts,
                                        "the three verts that the new face would have are those of a face already"};

template<class M>
struct edge_ring {
  cavity_builder<M> cavity;
  unsigned a = 0, b = 0;  // the ends of the edge
  unsigned ring[4] = {};  // the other verts of the tets around it, in cyclic order, beginning with those of the first
                          // tet of adj_e2p
  unsigned tet[4] = {};   // tet[i] has ring[i] and ring[i + 1]

  explicit edge_ring(const M& m) : cavity(m) {}
};

/// Finds the tets around e in cyclic order.
template<class M>
permission find_ring(const M& m, const edge_t<M>& e, edge_ring<M>& r) {
  cavity_builder<M>& c = r.cavity;
  const auto ends = end_verts(m, e);
  r.a = c.vert(ends.first), r.b = c.vert(ends.second);
  for (const poly_t<M> p : adj_e2p(m, e)) {
    if (c.num_old() == 4) return not_three_or_four;
    if (!c.add_old(p)) return not_simplices;
  }
  const unsigned n = c.num_old();
  if (n < 3 || c.num_verts() != n + 2) return not_three_or_four;
  const auto others = [&](unsigned k, unsigned (&two)[2]) {
    unsigned found = 0;
    for (unsigned i = 0; i < c.size; ++i)
      if (c.corners(k)[i] != r.a && c.corners(k)[i] != r.b) two[found++] = c.corners(k)[i];
  };
  unsigned two[2], last = 0;
  others(0, two);
  r.ring[0] = two[0];
  unsigned at = two[1];
  for (unsigned i = 1; i < n; ++i) {
    r.ring[i] = at;
    unsigned next = 0;
    while (next < n && (next == last || !c.has(next, at))) ++next;
    if (next == n) return not_three_or_four;
    others(next, two);
    at = two[0] == at ? two[1] : two[0];
    r.tet[i] = last = next;
  }
  if (at != r.ring[0] || has_repeated_polys(c)) return not_three_or_four;
  for (unsigned i = 0; i < n; ++i)
    if (!c.is_consistent(r.tet[i], r.ring[i], r.tet[(i + 1) % n], r.ring[(i + 2) % n])) return contradictory_winding;
  return {};
}

/// The tets around e are replaced: three by two, four by four around the new edge between ring[diagonal] and
/// ring[diagonal + 2].
template<class M>
permission edge_ring_cavity(const M& m, const edge_t<M>& e, unsigned diagonal, edge_ring<M>& r) {
  if (const permission p = find_ring(m, e, r); !p) return p;
  cavity_builder<M>& c = r.cavity;
  const auto replace = [&](unsigned i, unsigned by) {
    c.add_new(r.tet[i], r.b, by);
    c.add_new(r.tet[i], r.a, by);
  };
  if (c.num_old() == 3) {
    if (are_joined(m, c.vert_at(r.ring[0]), c.vert_at(r.ring[1]), c.vert_at(r.ring[2]))) return face_exists;
    replace(0, r.ring[2]);
  } else {
    if (are_joined(m, c.vert_at(r.ring[diagonal]), c.vert_at(r.ring[diagonal + 2]))) return opposite_verts_joined;
    replace(diagonal, r.ring[diagonal + 2]);
    replace(diagonal + 2, r.ring[diagonal]);
  }
  c.keep(c.num_old() == 3 ? 2 : 4);
  c.mix_origins();
  return {};
}

}  // namespace concino::detail
