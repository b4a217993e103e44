// Base classes for views: one refers to a base mesh, the others are mesh_traits that forward to it.
#pragma once

#include <concino/concepts/mesh.hpp>

namespace concino::views {

/// The base mesh of a view: stored by address if it owns its elements, as a copy if it is a view itself.
template<class M, bool = is_view_v<M>>
class view_base {
  const M* m_;

 public:
  constexpr explicit view_base(const M& m) : m_(&m) {}
  constexpr const M& base() const { return *m_; }
};

template<class V>
class view_base<V, true> {
  V v_;

 public:
  constexpr explicit view_base(const V& v) : v_(v) {}
  constexpr const V& base() const { return v_; }
};

}  // namespace concino::views

namespace concino::detail {

/// Forwards verts and adj_v2v to the base mesh of view V.
template<class V, class M>
struct forward_verts {
  using vert = vert_t<M>;
  static decltype(auto) verts(const V& m) { return traits<M>::verts(m.base()); }
  static std::size_t num_verts(const V& m) { return concino::num_verts(m.base()); }
  static std::size_t vert_index_bound(const V& m) { return concino::vert_index_bound(m.base()); }
  static std::size_t index_of(const V& m, const vert& x) { return concino::index_of(m.base(), x); }
  static bool contains(const V& m, const vert& x) { return concino::contains(m.base(), x); }
  static decltype(auto) adj_v2v(const V& m, const vert& x) { return traits<M>::adj_v2v(m.base(), x); }
};

/// Forwards polys and adj_p2p.
template<class V, class M>
struct forward_polys {
  using poly = poly_t<M>;
  static decltype(auto) polys(const V& m) { return traits<M>::polys(m.base()); }
  static std::size_t num_polys(const V& m) { return concino::num_polys(m.base()); }
  static std::size_t poly_index_bound(const V& m) { return concino::poly_index_bound(m.base()); }
  static std::size_t index_of(const V& m, const poly& x) { return concino::index_of(m.base(), x); }
  static bool contains(const V& m, const poly& x) { return concino::contains(m.base(), x); }
  static decltype(auto) adj_p2p(const V& m, const poly& x) { return traits<M>::adj_p2p(m.base(), x); }
};

/// Forwards both graphs, edges, and the adjacencies common to surfaces and volumes.
template<class V, class M>
struct forward_edges : forward_verts<V, M>, forward_polys<V, M> {
  using vert = vert_t<M>;
  using edge = edge_t<M>;
  using poly = poly_t<M>;
  static constexpr int dimension = dimension_v<M>;
  using forward_verts<V, M>::index_of;
  using forward_polys<V, M>::index_of;
  using forward_verts<V, M>::contains;
  using forward_polys<V, M>::contains;
  static decltype(auto) edges(const V& m) { return traits<M>::edges(m.base()); }
  static std::size_t num_edges(const V& m) { return concino::num_edges(m.base()); }
  static std::size_t edge_index_bound(const V& m) { return concino::edge_index_bound(m.base()); }
  static std::size_t index_of(const V& m, const edge& x) { return concino::index_of(m.base(), x); }
  static bool contains(const V& m, const edge& x) { return concino::contains(m.base(), x); }
  static decltype(auto) adj_v2e(const V& m, const vert& x) { return traits<M>::adj_v2e(m.base(), x); }
  static decltype(auto) adj_v2p(const V& m, const vert& x) { return traits<M>::adj_v2p(m.base(), x); }
  static decltype(auto) adj_e2v(const V& m, const edge& x) { return traits<M>::adj_e2v(m.base(), x); }
  static decltype(auto) adj_e2p(const V& m, const edge& x) { return traits<M>::adj_e2p(m.base(), x); }
  static decltype(auto) adj_p2v(const V& m, const poly& x) { return traits<M>::adj_p2v(m.base(), x); }
  static decltype(auto) adj_p2e(const V& m, const poly& x) { return concino::adj_p2e(m.base(), x); }
};

/// Forwards what volumes have in addition.
template<class V, class M>
struct forward_faces : forward_edges<V, M> {
  using vert = vert_t<M>;
  using edge = edge_t<M>;
  using face = face_t<M>;
  using poly = poly_t<M>;
  using forward_edges<V, M>::index_of;
  using forward_edges<V, M>::contains;
  static decltype(auto) faces(const V& m) { return traits<M>::faces(m.base()); }
  static std::size_t num_faces(const V& m) { return concino::num_faces(m.base()); }
  static std::size_t face_index_bound(const V& m) { return concino::face_index_bound(m.base()); }
  static std::size_t index_of(const V& m, const face& x) { return concino::index_of(m.base(), x); }
  static bool contains(const V& m, const face& x) { return concino::contains(m.base(), x); }
  static decltype(auto) adj_v2f(const V& m, const vert& x) { return traits<M>::adj_v2f(m.base(), x); }
  static decltype(auto) adj_e2f(const V& m, const edge& x) { return traits<M>::adj_e2f(m.base(), x); }
  static decltype(auto) adj_f2v(const V& m, const face& x) { return traits<M>::adj_f2v(m.base(), x); }
  static decltype(auto) adj_f2e(const V& m, const face& x) { return concino::adj_f2e(m.base(), x); }
  static decltype(auto) adj_f2p(const V& m, const face& x) { return traits<M>::adj_f2p(m.base(), x); }
  static decltype(auto) adj_p2f(const V& m, const poly& x) { return traits<M>::adj_p2f(m.base(), x); }
  static bool face_is_outward(const V& m, const poly& p, const face& f) {
    return concino::face_is_outward(m.base(), p, f);
  }
};

/// The largest of these sets that M models.
template<class V, class M, int = VolumeMesh<M> ? 3 : SurfaceMesh<M> ? 2 : PrimalGraph<M> ? 1 : 0> struct forward_all;
template<class V, class M> struct forward_all<V, M, 1> : forward_verts<V, M> {};
template<class V, class M> struct forward_all<V, M, 2> : forward_edges<V, M> {};
template<class V, class M> struct forward_all<V, M, 3> : forward_faces<V, M> {};

/// Forwards points, if M has them.
template<class V, class M, bool = Embedded<M>> struct forward_points {};
template<class V, class M>
struct forward_points<V, M, true> {
  static decltype(auto) point(const V& m, const vert_t<M>& x) { return traits<M>::point(m.base(), x); }
};

/// Forwards named properties and the numbers of corners, if M has them.
template<class V, class M>
struct forward_properties {
  template<class B = M>
    requires requires(const B& m) { traits<B>::properties(m); }
  static const auto& properties(const V& m) { return traits<B>::properties(m.base()); }
  template<class B = M>
    requires requires(const B& m, const poly_t<B>& p) { traits<B>::first_corner(m, p); }
  static std::size_t first_corner(const V& m, const poly_t<B>& p) { return traits<B>::first_corner(m.base(), p); }
  template<class B = M>
    requires requires(const B& m) { traits<B>::corner_index_bound(m); }
  static std::size_t corner_index_bound(const V& m) { return traits<B>::corner_index_bound(m.base()); }
};

/// Forwards the numbers by which messages name elements, if M has them.
template<class V, class M>
struct forward_numbers {
  template<class X, class B = M>
    requires requires(const B& m, const X& x) { traits<B>::number_in_messages(m, x); }
  static std::size_t number_in_messages(const V& m, const X& x) { return traits<B>::number_in_messages(m.base(), x); }
};

/// The arity of polys, if it is fixed.
template<int Arity> struct fixed_arity { static constexpr int arity = Arity; };
template<> struct fixed_arity<0> {};

}  // namespace concino::detail
