// The class template archetype and its mesh_traits, which have exactly the selected parts.
#pragma once

#include <concino/concepts/archetypes/opaque.hpp>

namespace concino::archetypes {

/// The parts of a mesh that an archetype can have.
enum parts : unsigned {
  primal = 1,                    ///< verts and adj_v2v
  dual = 2,                      ///< polys and adj_p2p
  mesh = 4 | primal | dual,      ///< edges, faces, every adjacency, dimension
  points = 8,
  arity = 16
};
constexpr parts operator|(parts a, parts b) {
  return static_cast<parts>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
/// Whether `all` includes `some`.
/// Needs:  sets of the parts above.      Result: true if each part of `some` is one of `all`.      Cost: O(1).
/// Errors: none.
constexpr bool has(parts all, parts some) {
  return (static_cast<unsigned>(all) & static_cast<unsigned>(some)) == static_cast<unsigned>(some);
}

/// A view of m that has the parts P and hides the rest.
template<class M, parts P>
class archetype {
  const M* m_;

 public:
  constexpr explicit archetype(const M& m) : m_(&m) {}
  constexpr const M& base() const { return *m_; }

  /// Conversion of an element of base() to an opaque descriptor, and back.
  template<class V = M>
  constexpr auto vert(const vert_t<V>& x) const {
    return access::wrap<opaque<vert_t<V>, vert_tag>>(x);
  }
  template<class V = M>
  constexpr auto edge(const edge_t<V>& x) const {
    return access::wrap<opaque<edge_t<V>, edge_tag>>(x);
  }
  template<class V = M>
  constexpr auto face(const face_t<V>& x) const {
    return access::wrap<opaque<face_t<V>, face_tag>>(x);
  }
  template<class V = M>
  constexpr auto poly(const poly_t<V>& x) const {
    return access::wrap<opaque<poly_t<V>, poly_tag>>(x);
  }
  template<class Base, class Tag> constexpr Base base(const opaque<Base, Tag>& o) const { return access::base(o); }
};

/// The same archetype as a mesh that owns its elements: it is not a view and cannot be copied or moved. For algorithms
/// that store a mesh or a pointer to it.
template<class A>
struct owner : A {
  using A::A;
  owner(const owner&) = delete;
  owner& operator=(const owner&) = delete;
};

template<class M, bool> struct vert_type {};
template<class M> struct vert_type<M, true> { using vert = opaque<vert_t<M>, vert_tag>; };
template<class M, bool> struct poly_type {};
template<class M> struct poly_type<M, true> { using poly = opaque<poly_t<M>, poly_tag>; };
template<class M, bool> struct edge_type {};
template<class M> struct edge_type<M, true> {
  using edge = opaque<edge_t<M>, edge_tag>;
  static constexpr int dimension = dimension_v<M>;
};
template<class M, bool> struct face_type {};
template<class M> struct face_type<M, true> { using face = opaque<face_t<M>, face_tag>; };
template<class M, bool> struct arity_value {};
template<class M> struct arity_value<M, true> { static constexpr int arity = arity_v<M>; };

}  // namespace concino::archetypes

namespace concino {

template<class M, archetypes::parts P>
struct mesh_traits<archetypes::archetype<M, P>>
    : archetypes::vert_type<M, has(P, archetypes::primal) || has(P, archetypes::points)>,
      archetypes::poly_type<M, has(P, archetypes::dual)>,
      archetypes::edge_type<M, has(P, archetypes::mesh)>,
      archetypes::face_type<M, has(P, archetypes::mesh) && dimension_v<M> == 3>,
      archetypes::arity_value<M, has(P, archetypes::arity)> {
  static constexpr bool is_view = true;

 private:
  using A = archetypes::archetype<M, P>;
  using T = traits<M>;
  // Not the types of the base classes, which may be missing.
  template<class X> using v = archetypes::opaque<vert_t<X>, vert_tag>;
  template<class X> using e = archetypes::opaque<edge_t<X>, edge_tag>;
  template<class X> using f = archetypes::opaque<face_t<X>, face_tag>;
  template<class X> using p = archetypes::opaque<poly_t<X>, poly_tag>;
  static constexpr bool primal = has(P, archetypes::primal);
  static constexpr bool dual = has(P, archetypes::dual);
  static constexpr bool mesh = has(P, archetypes::mesh);
  static constexpr bool volume = mesh && dimension_v<M> == 3;

  using index_like = archetypes::index_like;
  template<class D> static constexpr decltype(auto) in(const D& d) { return archetypes::access::base(d); }
  template<class O, class F> static constexpr auto out(const F& make) { return archetypes::rewrap<O>(make); }

 public:
  // clang-format off
  template<class X = M> requires primal static constexpr auto verts(const A& a) { return out<v<X>>([&]() -> decltype(auto) { return T::verts(a.base()); }); }
  template<class X = M> requires mesh static constexpr auto edges(const A& a) { return out<e<X>>([&]() -> decltype(auto) { return T::edges(a.base()); }); }
  template<class X = M> requires volume static constexpr auto faces(const A& a) { return out<f<X>>([&]() -> decltype(auto) { return T::faces(a.base()); }); }
  template<class X = M> requires dual static constexpr auto polys(const A& a) { return out<p<X>>([&]() -> decltype(auto) { return T::polys(a.base()); }); }

  template<class X = M> requires primal static constexpr index_like num_verts(const A& a) { return index_like(concino::num_verts(a.base())); }
  template<class X = M> requires mesh static constexpr index_like num_edges(const A& a) { return index_like(concino::num_edges(a.base())); }
  template<class X = M> requires volume static constexpr index_like num_faces(const A& a) { return index_like(concino::num_faces(a.base())); }
  template<class X = M> requires dual static constexpr index_like num_polys(const A& a) { return index_like(concino::num_polys(a.base())); }

  template<class X = M> requires primal static constexpr index_like vert_index_bound(const A& a) { return index_like(concino::vert_index_bound(a.base())); }
  template<class X = M> requires mesh static constexpr index_like edge_index_bound(const A& a) { return index_like(concino::edge_index_bound(a.base())); }
  template<class X = M> requires volume static constexpr index_like face_index_bound(const A& a) { return index_like(concino::face_index_bound(a.base())); }
  template<class X = M> requires dual static constexpr index_like poly_index_bound(const A& a) { return index_like(concino::poly_index_bound(a.base())); }

  template<class X = M> requires primal static constexpr index_like index_of(const A& a, const v<X>& x) { return index_like(concino::index_of(a.base(), in(x))); }
  template<class X = M> requires mesh static constexpr index_like index_of(const A& a, const e<X>& x) { return index_like(concino::index_of(a.base(), in(x))); }
  template<class X = M> requires volume static constexpr index_like index_of(const A& a, const f<X>& x) { return index_like(concino::index_of(a.base(), in(x))); }
  template<class X = M> requires dual static constexpr index_like index_of(const A& a, const p<X>& x) { return index_like(concino::index_of(a.base(), in(x))); }

  template<class X = M> requires primal static constexpr auto adj_v2v(const A& a, const v<X>& x) { return out<v<X>>([&]() -> decltype(auto) { return T::adj_v2v(a.base(), in(x)); }); }
  template<class X = M> requires mesh static constexpr auto adj_v2e(const A& a, const v<X>& x) { return out<e<X>>([&]() -> decltype(auto) { return T::adj_v2e(a.base(), in(x)); }); }
  template<class X = M> requires volume static constexpr auto adj_v2f(const A& a, const v<X>& x) { return out<f<X>>([&]() -> decltype(auto) { return T::adj_v2f(a.base(), in(x)); }); }
  template<class X = M> requires mesh static constexpr auto adj_v2p(const A& a, const v<X>& x) { return out<p<X>>([&]() -> decltype(auto) { return T::adj_v2p(a.base(), in(x)); }); }

  template<class X = M> requires mesh static constexpr auto adj_e2v(const A& a, const e<X>& x) { return out<v<X>>([&]() -> decltype(auto) { return T::adj_e2v(a.base(), in(x)); }); }
  template<class X = M> requires volume static constexpr auto adj_e2f(const A& a, const e<X>& x) { return out<f<X>>([&]() -> decltype(auto) { return T::adj_e2f(a.base(), in(x)); }); }
  template<class X = M> requires mesh static constexpr auto adj_e2p(const A& a, const e<X>& x) { return out<p<X>>([&]() -> decltype(auto) { return T::adj_e2p(a.base(), in(x)); }); }

  template<class X = M> requires volume static constexpr auto adj_f2v(const A& a, const f<X>& x) { return out<v<X>>([&]() -> decltype(auto) { return T::adj_f2v(a.base(), in(x)); }); }
  template<class X = M> requires volume static constexpr auto adj_f2e(const A& a, const f<X>& x) { return out<e<X>>([&]() -> decltype(auto) { return concino::adj_f2e(a.base(), in(x)); }); }
  template<class X = M> requires volume static constexpr auto adj_f2p(const A& a, const f<X>& x) { return out<p<X>>([&]() -> decltype(auto) { return T::adj_f2p(a.base(), in(x)); }); }

  template<class X = M> requires mesh static constexpr auto adj_p2v(const A& a, const p<X>& x) { return out<v<X>>([&]() -> decltype(auto) { return T::adj_p2v(a.base(), in(x)); }); }
  template<class X = M> requires mesh static constexpr auto adj_p2e(const A& a, const p<X>& x) { return out<e<X>>([&]() -> decltype(auto) { return concino::adj_p2e(a.base(), in(x)); }); }
  template<class X = M> requires volume static constexpr auto adj_p2f(const A& a, const p<X>& x) { return out<f<X>>([&]() -> decltype(auto) { return T::adj_p2f(a.base(), in(x)); }); }
  template<class X = M> requires dual static constexpr auto adj_p2p(const A& a, const p<X>& x) { return out<p<X>>([&]() -> decltype(auto) { return T::adj_p2p(a.base(), in(x)); }); }

  // clang-format on

  template<class X = M>
    requires volume
  static constexpr archetypes::boolean_like face_is_outward(const A& a, const p<X>& x, const f<X>& y) {
    return archetypes::boolean_like(T::face_is_outward(a.base(), in(x), in(y)));
  }
  template<class X = M>
    requires(has(P, archetypes::points))
  static constexpr archetypes::point_like point(const A& a, const v<X>& x) {
    const auto& at = T::point(a.base(), in(x));
    return {static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])};
  }
};

template<class A>
struct mesh_traits<archetypes::owner<A>> : mesh_traits<A> {
  static constexpr bool is_view = false;
};

}  // namespace concino
