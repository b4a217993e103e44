// The verbs: the functions with which algorithms access a mesh. Each is a function object that forwards to mesh_traits,
// so that argument-dependent lookup never finds a function of another library. A verb cannot be called if the traits
// lack the member. Those of adjacency, adj_v2v to adj_p2p, are in adjacency_verbs.hpp.
//
// Needs:  a member of mesh_traits<M> of the same name; elements of m, which is not checked: use contains(m, x).
// Result: what that member returns: ranges of elements, numbers as std::size_t, points of the type that the mesh has.
// Cost:   that of the member; nothing is added.
// Errors: those of the member.
#pragma once

#include <concino/concepts/adjacency_verbs.hpp>
#include <concino/concepts/mesh_traits.hpp>

#include <concepts>
#include <type_traits>

namespace concino {

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
  constexpr std::size_t operator()(const M& m) const {
    return static_cast<std::size_t>(traits<M>::vert_index_bound(m));
  }
} vert_index_bound{};

inline constexpr struct edge_index_bound_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::edge_index_bound(m); }
  constexpr std::size_t operator()(const M& m) const {
    return static_cast<std::size_t>(traits<M>::edge_index_bound(m));
  }
} edge_index_bound{};

inline constexpr struct face_index_bound_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::face_index_bound(m); }
  constexpr std::size_t operator()(const M& m) const {
    return static_cast<std::size_t>(traits<M>::face_index_bound(m));
  }
} face_index_bound{};

inline constexpr struct poly_index_bound_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { traits<M>::poly_index_bound(m); }
  constexpr std::size_t operator()(const M& m) const {
    return static_cast<std::size_t>(traits<M>::poly_index_bound(m));
  }
} poly_index_bound{};

/// A number below the index bound, different for different elements.
inline constexpr struct index_of_verb : detail::verb {
  using verb::operator();
  template<class M, class X>
    requires requires(const M& m, const X& x) { traits<M>::index_of(m, x); }
  constexpr std::size_t operator()(const M& m, const X& x) const {
    return static_cast<std::size_t>(traits<M>::index_of(m, x));
  }
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
  constexpr void operator()(M& m, const cavity<M>& c, const cavity_result<M>& made) const {
    traits<M>::rewire(m, c, made);
  }
} rewire{};

/// Whether face f of poly p, in the order of adj_f2v, runs counter-clockwise seen from outside p.
inline constexpr struct face_is_outward_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, poly_t<M> p, face_t<M> f) { traits<M>::face_is_outward(m, p, f); }
  constexpr bool operator()(const M& m, poly_t<M> p, face_t<M> f) const {
    return static_cast<bool>(traits<M>::face_is_outward(m, p, f));
  }
} face_is_outward{};

}  // namespace concino
