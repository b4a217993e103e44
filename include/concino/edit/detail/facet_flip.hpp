// The cavity of a flip of a facet between two simplices: an edge between triangles, a face between tets.
#pragma once

#include <concino/edit/connected_verts.hpp>
#include <concino/edit/detail/propose.hpp>

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>

namespace concino::detail {

inline constexpr permission not_two_polys{refusal::wrong_number,
                                          "the edge does not have two triangles, or the face does not have two tets"};
inline constexpr permission opposite_verts_joined{
    refusal::same_verts, "the two verts that the new edge would join are the same, or are joined already"};
inline constexpr permission contradictory_winding{refusal::winding,
                                                  "the polys at the element run in contradictory directions"};

/// The edge between two verts, which are joined.
template<class M>
edge_t<M> edge_between_verts(const M& m, const vert_t<M>& a, const vert_t<M>& b) {
  for (const edge_t<M> e : adj_v2e(m, a)) {
    const auto ends = end_verts(m, e);
    if (ends.first == b || ends.second == b) return e;
  }
  return edge_t<M>{};
}

template<class M>
struct facet_flip {
  cavity_builder<M> cavity;
  unsigned first = 0, second = 0;  // the verts opposite to the facet, which the new edge joins

  explicit facet_flip(const M& m) : cavity(m) {}
};

/// The two polys at the facet are replaced by one poly for each vert of the facet: it has the other verts of the facet
/// and both opposite verts.
template<class M>
permission facet_flip_cavity(const M& m, const facet_t<M>& x, facet_flip<M>& f) {
  cavity_builder<M>& c = f.cavity;
  unsigned corners[cavity_builder<M>::size], n = 0, opposite[2] = {};
  for (const vert_t<M> v : adj_facet2v(m, x)) {
    if (n == c.size - 1) return not_simplices;
    corners[n++] = c.vert(v);
  }
  for (const poly_t<M> p : adj_facet2p(m, x)) {
    if (c.num_old() == 2) return not_two_polys;
    if (!c.add_old(p)) return not_simplices;
  }
  if (c.num_old() != 2) return not_two_polys;
  for (unsigned k = 0; k < 2; ++k)
    for (unsigned i = 0; i < c.size; ++i)
      if (std::find(corners, corners + n, c.corners(k)[i]) == corners + n) opposite[k] = c.corners(k)[i];
  f.first = opposite[0], f.second = opposite[1];
  if (f.first == f.second) return opposite_verts_joined;
  if (!c.is_consistent(0, f.first, 1, f.second)) return contradictory_winding;
  if (are_joined(m, c.vert_at(f.first), c.vert_at(f.second))) return opposite_verts_joined;
  c.add_new(0, corners[n - 1], f.second);
  while (--n > 0) c.add_new(1, corners[n - 1], f.first);
  c.keep(2);
  c.mix_origins();
  return {};
}

template<class M>
permission can_flip_facet(const M& m, const facet_t<M>& x, const std::vector<invariant>& keep) {
  facet_flip<M> f(m);
  if (const permission p = facet_flip_cavity(m, x, f); !p) return p;
  return ask(keep, m, f.cavity);
}

/// The edge that a flip of facet x makes.
template<class M>
edge_result<M> flip_facet(M& m, const facet_t<M>& x, const std::vector<invariant>& keep) {
  facet_flip<M> f(m);
  if (const permission p = facet_flip_cavity(m, x, f); !p) return {p};
  if (const permission p = ask(keep, m, f.cavity); !p) return {p};
  f.cavity.apply(m);
  return {{}, edge_between_verts(m, f.cavity.vert_at(f.first), f.cavity.vert_at(f.second))};
}

}  // namespace concino::detail
