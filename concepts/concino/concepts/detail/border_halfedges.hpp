// Border half-edges for links of libraries that have none.
#pragma once

#include <concino/concepts/mesh_traits.hpp>

namespace concino::detail {

/// Adds border half-edges to links that have none. The border half-edge of an edge is stored as the half-edge on its
/// other side; the next one along the border is found by a walk around the vert between them.
template<class M, class K>
struct border_halfedges {
  using vert = typename K::vert;
  using edge = typename K::edge;
  using poly = typename K::poly;
  struct halfedge {
    typename K::halfedge inner{};
    bool border = false;
    friend bool operator==(const halfedge&, const halfedge&) = default;
  };

  static halfedge opposite(const M& m, const halfedge& h) {
    if (h.border) return {h.inner, false};
    if (K::has_opposite(m, h.inner)) return {K::opposite(m, h.inner), false};
    return {h.inner, true};
  }
  static halfedge next(const M& m, const halfedge& h) {
    if (!h.border) return {K::next(m, h.inner), false};
    typename K::halfedge g = previous(m, h.inner);
    while (K::has_opposite(m, g)) g = previous(m, K::opposite(m, g));
    return {g, true};
  }
  static vert target(const M& m, const halfedge& h) { return K::target(m, h.border ? previous(m, h.inner) : h.inner); }
  static bool is_border(const M&, const halfedge& h) { return h.border; }
  static poly poly_of(const M& m, const halfedge& h) { return K::poly_of(m, h.inner); }
  static edge edge_of(const M& m, const halfedge& h) { return K::edge_of(m, h.inner); }
  static bool is_isolated(const M& m, const vert& v) { return K::is_isolated(m, v); }
  template<class X> static halfedge halfedge_of(const M& m, const X& x) { return {K::halfedge_of(m, x), false}; }

 private:
  static typename K::halfedge previous(const M& m, const typename K::halfedge& h) {
    if constexpr (requires { K::previous(m, h); }) {
      return K::previous(m, h);
    } else {
      typename K::halfedge g = K::next(m, h), after = K::next(m, g);
      for (; !(after == h); after = K::next(m, g)) g = after;
      return g;
    }
  }
};

template<class M, class K, bool HasBorder> struct complete_links { using type = K; };
template<class M, class K> struct complete_links<M, K, false> { using type = border_halfedges<M, K>; };
/// Links with border half-edges: K itself, or border_halfedges of it.
template<class M, class K>
using links_with_border = typename complete_links<M, K, !requires { requires !K::has_border_halfedges; }>::type;

}  // namespace concino::detail
