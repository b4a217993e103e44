// The verbs: the functions with which algorithms access a mesh. Each is a function object that forwards to mesh_traits, so that argument-dependent
// lookup never finds a function of another library. A verb cannot be called if the traits lack the member.
//
// Needs:  a member of mesh_traits<M> of the same name; elements of m, which is not checked: use contains(m, x).
// Result: what that member returns: ranges of elements, numbers as std::size_t, points of the type that the mesh has.
// Cost:   that of the member; nothing is added.
// Errors: those of the member.
#pragma once

#include <concino/concepts/detail/sorted_edges.hpp>
#include <concino/concepts/mesh_traits.hpp>

#include <concepts>
#include <type_traits>

namespace concino {

namespace detail {

template<class M> struct order_of_edges;  // defined in sorted_edges.hpp; either header may be included first

}  // namespace detail

/// All existing elements of one kind, in an order that does not change while the mesh does not.
inline constexpr struct verts_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::verts(m); }
  constexpr decltype(auto) operator()(const M& m) const { return traits<M>::verts(m); }
} verts{};

inline constexpr struct edges_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::edges(m); }
  constexpr decltype(auto) operator()(const M& m) const { return traits<M>::edges(m); }
} edges{};

inline constexpr struct faces_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::faces(m); }
  constexpr decltype(auto) operator()(const M& m) const { return traits<M>::faces(m); }
} faces{};

inline constexpr struct polys_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::polys(m); }
  constexpr decltype(auto) operator()(const M& m) const { return traits<M>::polys(m); }
} polys{};

/// The number of elements in that range.
inline constexpr struct num_verts_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::num_verts(m); }
  constexpr std::size_t operator()(const M& m) const { return static_cast<std::size_t>(traits<M>::num_verts(m)); }
} num_verts{};

inline constexpr struct num_edges_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::num_edges(m); }
  constexpr std::size_t operator()(const M& m) const { return static_cast<std::size_t>(traits<M>::num_edges(m)); }
} num_edges{};

inline constexpr struct num_faces_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::num_faces(m); }
  constexpr std::size_t operator()(const M& m) const { return static_cast<std::size_t>(traits<M>::num_faces(m)); }
} num_faces{};

inline constexpr struct num_polys_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::num_polys(m); }
  constexpr std::size_t operator()(const M& m) const { return static_cast<std::size_t>(traits<M>::num_polys(m)); }
} num_polys{};

/// Exclusive upper bound of index_of: an array of this size has a value for every element. Deleted elements leave gaps.
inline constexpr struct vert_index_bound_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::vert_index_bound(m); }
  constexpr std::size_t operator()(const M& m) const { return static_cast<std::size_t>(traits<M>::vert_index_bound(m)); }
} vert_index_bound{};

inline constexpr struct edge_index_bound_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::edge_index_bound(m); }
  constexpr std::size_t operator()(const M& m) const { return static_cast<std::size_t>(traits<M>::edge_index_bound(m)); }
} edge_index_bound{};

inline constexpr struct face_index_bound_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::face_index_bound(m); }
  constexpr std::size_t operator()(const M& m) const { return static_cast<std::size_t>(traits<M>::face_index_bound(m)); }
} face_index_bound{};

inline constexpr struct poly_index_bound_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::poly_index_bound(m); }
  constexpr std::size_t operator()(const M& m) const { return static_cast<std::size_t>(traits<M>::poly_index_bound(m)); }
} poly_index_bound{};

/// A number below the index bound, different for different elements.
inline constexpr struct index_of_verb : detail::verb {
  using verb::operator();
  template<class M, class X>
    requires requires(const M& m, const X& x) { traits<M>::index_of(m, x); }
  constexpr std::size_t operator()(const M& m, const X& x) const { return static_cast<std::size_t>(traits<M>::index_of(m, x)); }
} index_of{};

/// The position of a vert: p[0], p[1], p[2].
inline constexpr struct point_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, vert_t<M> v) { traits<M>::point(m, v); }
  constexpr decltype(auto) operator()(const M& m, vert_t<M> v) const { return traits<M>::point(m, v); }
} point{};

/// Moves a vert.
inline constexpr struct set_point_verb : detail::verb {
  using verb::operator();
  template<class M, class P>
    requires requires(M& m, vert_t<M> v, const P& p) { traits<M>::set_point(m, v, p); }
  constexpr void operator()(M& m, vert_t<M> v, const P& p) const { traits<M>::set_point(m, v, p); }
} set_point{};

/// Replaces the old polys of a cavity by the new ones, at once. The descriptors of new elements are written to `made`.
inline constexpr struct rewire_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(M& m, const cavity<M>& c, const cavity_result<M>& made) { traits<M>::rewire(m, c, made); }
  constexpr void operator()(M& m, const cavity<M>& c, const cavity_result<M>& made) const { traits<M>::rewire(m, c, made); }
} rewire{};

/// Whether face f of poly p, in the order of adj_f2v, runs counter-clockwise seen from outside p.
inline constexpr struct face_is_outward_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, poly_t<M> p, face_t<M> f) { traits<M>::face_is_outward(m, p, f); }
  constexpr bool operator()(const M& m, poly_t<M> p, face_t<M> f) const { return static_cast<bool>(traits<M>::face_is_outward(m, p, f)); }
} face_is_outward{};

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

/// The edges of f in the order of its verts: edge k joins the verts k and k + 1 of adj_f2v. If the traits say edges_in_order = false, they are sorted:
/// k^2 comparisons for k edges up to 8; for more, a search through the edges at the ends of each.
inline constexpr struct adj_f2e_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, face_t<M> f) { traits<M>::adj_f2e(m, f); } && requirement::can_sort_edges_of_faces<M>
  constexpr decltype(auto) operator()(const M& m, face_t<M> f) const {
    if constexpr (detail::order_of_edges<M>::sorts_those_of_faces) return typename detail::order_of_edges<M>::of_face(m, f);
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

/// The edges of p. On a surface they are in the order of its verts: edge k joins the verts k and k + 1 of adj_p2v. Those of a tet join its verts
/// 01 02 03 12 13 23. If the traits say edges_in_order = false, they are sorted as those of a face are.
inline constexpr struct adj_p2e_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, poly_t<M> p) { traits<M>::adj_p2e(m, p); } && requirement::can_sort_edges_of_polys<M>
  constexpr decltype(auto) operator()(const M& m, poly_t<M> p) const {
    if constexpr (detail::order_of_edges<M>::sorts_those_of_polys) return typename detail::order_of_edges<M>::of_poly(m, p);
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
