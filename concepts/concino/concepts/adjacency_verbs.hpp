// The verbs of adjacency: adj_v2v, the verts joined to a vert, to adj_p2p, the polys beside a poly. Part of verbs.hpp.
//
// Needs:  as the other verbs.
// Result: a range of elements, which may refer to the mesh.
// Cost:   that of the member; nothing is added, but where edges are sorted.
// Errors: those of the member.
#pragma once

#include <concino/concepts/detail/sorted_edges.hpp>
#include <concino/concepts/mesh_traits.hpp>

namespace concino {

namespace detail {

template<class M> struct order_of_edges;  // defined in sorted_edges.hpp; either header may be included first

}  // namespace detail

/// The verts joined to v by an edge.
inline constexpr struct adj_v2v_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, vert_t<M> v) { traits<M>::adj_v2v(m, v); }
  constexpr decltype(auto) operator()(const M& m, vert_t<M> v) const { return traits<M>::adj_v2v(m, v); }
} adj_v2v{};

/// The edges at v.
inline constexpr struct adj_v2e_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, vert_t<M> v) { traits<M>::adj_v2e(m, v); }
  constexpr decltype(auto) operator()(const M& m, vert_t<M> v) const { return traits<M>::adj_v2e(m, v); }
} adj_v2e{};

/// The faces at v.
inline constexpr struct adj_v2f_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, vert_t<M> v) { traits<M>::adj_v2f(m, v); }
  constexpr decltype(auto) operator()(const M& m, vert_t<M> v) const { return traits<M>::adj_v2f(m, v); }
} adj_v2f{};

/// The polys at v.
inline constexpr struct adj_v2p_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, vert_t<M> v) { traits<M>::adj_v2p(m, v); }
  constexpr decltype(auto) operator()(const M& m, vert_t<M> v) const { return traits<M>::adj_v2p(m, v); }
} adj_v2p{};

/// The two ends of e.
inline constexpr struct adj_e2v_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, edge_t<M> e) { traits<M>::adj_e2v(m, e); }
  constexpr decltype(auto) operator()(const M& m, edge_t<M> e) const { return traits<M>::adj_e2v(m, e); }
} adj_e2v{};

/// The faces at e.
inline constexpr struct adj_e2f_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, edge_t<M> e) { traits<M>::adj_e2f(m, e); }
  constexpr decltype(auto) operator()(const M& m, edge_t<M> e) const { return traits<M>::adj_e2f(m, e); }
} adj_e2f{};

/// The polys at e.
inline constexpr struct adj_e2p_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, edge_t<M> e) { traits<M>::adj_e2p(m, e); }
  constexpr decltype(auto) operator()(const M& m, edge_t<M> e) const { return traits<M>::adj_e2p(m, e); }
} adj_e2p{};

/// The verts of f in cyclic order.
inline constexpr struct adj_f2v_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, face_t<M> f) { traits<M>::adj_f2v(m, f); }
  constexpr decltype(auto) operator()(const M& m, face_t<M> f) const { return traits<M>::adj_f2v(m, f); }
} adj_f2v{};

/// The edges of f in the order of its verts: edge k joins the verts k and k + 1 of adj_f2v. If the traits say
/// edges_in_order = false, they are sorted: k^2 comparisons for k edges up to 8; for more, a search through the edges
/// at the ends of each.
inline constexpr struct adj_f2e_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, face_t<M> f) { traits<M>::adj_f2e(m, f); } && requirement::can_sort_edges_of_faces<M>
  constexpr decltype(auto) operator()(const M& m, face_t<M> f) const {
    if constexpr (detail::order_of_edges<M>::sorts_those_of_faces)
      return typename detail::order_of_edges<M>::of_face(m, f);
    else return traits<M>::adj_f2e(m, f);
  }
  template<class M, class R = mistake::remedy<mistake::give_edge_order_of_faces>>
    requires(!requirement::can_sort_edges_of_faces<M>)
  void operator()(const M& m, face_t<M> f) const = delete;  // edges_in_order = false: to sort, adj_f2e needs adj_f2v, adj_e2v, adj_v2e and adj_e2f
} adj_f2e{};

/// The polys of f, on its two sides.
inline constexpr struct adj_f2p_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, face_t<M> f) { traits<M>::adj_f2p(m, f); }
  constexpr decltype(auto) operator()(const M& m, face_t<M> f) const { return traits<M>::adj_f2p(m, f); }
} adj_f2p{};

/// The verts of p (surfaces: in cyclic order; tets and hexes: in the standard order).
inline constexpr struct adj_p2v_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, poly_t<M> p) { traits<M>::adj_p2v(m, p); }
  constexpr decltype(auto) operator()(const M& m, poly_t<M> p) const { return traits<M>::adj_p2v(m, p); }
} adj_p2v{};

/// The edges of p. On a surface they are in the order of its verts: edge k joins the verts k and k + 1 of adj_p2v.
/// Those of a tet join its verts 01 02 03 12 13 23. If the traits say edges_in_order = false, they are sorted as those
/// of a face are.
inline constexpr struct adj_p2e_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, poly_t<M> p) { traits<M>::adj_p2e(m, p); } && requirement::can_sort_edges_of_polys<M>
  constexpr decltype(auto) operator()(const M& m, poly_t<M> p) const {
    if constexpr (detail::order_of_edges<M>::sorts_those_of_polys)
      return typename detail::order_of_edges<M>::of_poly(m, p);
    else return traits<M>::adj_p2e(m, p);
  }
  template<class M, class R = mistake::remedy<mistake::give_edge_order_of_polys>>
    requires(!requirement::can_sort_edges_of_polys<M>)
  void operator()(const M& m, poly_t<M> p) const = delete;  // edges_in_order = false: to sort, adj_p2e needs adj_p2v and adj_e2v, on a surface adj_v2e and adj_e2p too
} adj_p2e{};

/// The faces of p.
inline constexpr struct adj_p2f_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, poly_t<M> p) { traits<M>::adj_p2f(m, p); }
  constexpr decltype(auto) operator()(const M& m, poly_t<M> p) const { return traits<M>::adj_p2f(m, p); }
} adj_p2f{};

/// The polys behind the edges of p (surface) or behind the faces of p (volume).
inline constexpr struct adj_p2p_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, poly_t<M> p) { traits<M>::adj_p2p(m, p); }
  constexpr decltype(auto) operator()(const M& m, poly_t<M> p) const { return traits<M>::adj_p2p(m, p); }
} adj_p2p{};

}  // namespace concino
