// Facets: the edges of a surface, the faces of a volume. They separate polys. Algorithms for both dimensions use these
// verbs, which are derived for every AnyMesh from the members of its traits.
//
// Laws, which follow from those of the mesh if no verb changes the result of another:
//   FC1  index_of of facets is below facet_index_bound and differs; iterating over facets(m) yields num_facets(m), each
//        once
//   FC2  adj_facet2p mirrors adj_p2facet, nothing twice; the verts adj_facet2v(x) are verts of each poly of x
//   FC3  other_polys(m, p, x) is adj_facet2p(x) without p; together, those of all facets of p are adj_p2p(p)
//   FC4  is_boundary(m, x) of a facet: adj_facet2p(x) is one poly; of any other element: it has such a facet
//
// Contract of the verbs below, unless they have their own:
// Needs:  the verb of the same meaning for edges (surface) or for faces (volume).
// Result: what that verb returns.
// Cost:   that of the verb; nothing is added.
// Errors: those of the verb.
#pragma once

#include <concino/concepts/mesh.hpp>

namespace concino {

namespace detail {

template<class M> struct facet_of {};
template<class M>
  requires(dimension_v<M> == 2 && requirement::has_edge<M>)
struct facet_of<M> { using type = edge_t<M>; };
template<class M>
  requires(dimension_v<M> == 3 && requirement::has_face<M>)
struct facet_of<M> { using type = face_t<M>; };

}  // namespace detail

/// The type of facets, edges of surfaces or faces of volumes: what bounds polys and, if it has only one poly, the mesh.
template<class M> using facet_t = typename detail::facet_of<std::remove_cvref_t<M>>::type;

namespace detail {

/// Whether the range has exactly one element.
template<class R>
constexpr bool is_single(const R& range) {
  auto it = range.begin();
  const auto end = range.end();
  if (!(it != end)) return false;
  ++it;
  return !(it != end);
}

}  // namespace detail

/// The facets of m, each once: edges or faces.
inline constexpr struct facets_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { requires dimension_v<M> == 2; edges(m); }
  constexpr decltype(auto) operator()(const M& m) const { return edges(m); }
  template<class M>
    requires requires(const M& m) { requires dimension_v<M> == 3; faces(m); }
  constexpr decltype(auto) operator()(const M& m) const { return faces(m); }
} facets{};

/// The number of facets in facets(m).
inline constexpr struct num_facets_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { requires dimension_v<M> == 2; num_edges(m); }
  constexpr std::size_t operator()(const M& m) const { return num_edges(m); }
  template<class M>
    requires requires(const M& m) { requires dimension_v<M> == 3; num_faces(m); }
  constexpr std::size_t operator()(const M& m) const { return num_faces(m); }
} num_facets{};

/// Exclusive upper bound of index_of of facets.
inline constexpr struct facet_index_bound_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m) { requires dimension_v<M> == 2; edge_index_bound(m); }
  constexpr std::size_t operator()(const M& m) const { return edge_index_bound(m); }
  template<class M>
    requires requires(const M& m) { requires dimension_v<M> == 3; face_index_bound(m); }
  constexpr std::size_t operator()(const M& m) const { return face_index_bound(m); }
} facet_index_bound{};

/// The facets of a poly: adj_p2e or adj_p2f.
inline constexpr struct adj_p2facet_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, poly_t<M> p) { requires dimension_v<M> == 2; adj_p2e(m, p); }
  constexpr decltype(auto) operator()(const M& m, poly_t<M> p) const { return adj_p2e(m, p); }
  template<class M>
    requires requires(const M& m, poly_t<M> p) { requires dimension_v<M> == 3; adj_p2f(m, p); }
  constexpr decltype(auto) operator()(const M& m, poly_t<M> p) const { return adj_p2f(m, p); }
} adj_p2facet{};

/// The polys of a facet: in a manifold, two in the interior and one at the boundary. adj_e2p or adj_f2p.
inline constexpr struct adj_facet2p_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, edge_t<M> e) { requires dimension_v<M> == 2; adj_e2p(m, e); }
  constexpr decltype(auto) operator()(const M& m, edge_t<M> e) const { return adj_e2p(m, e); }
  template<class M>
    requires requires(const M& m, face_t<M> f) { requires dimension_v<M> == 3; adj_f2p(m, f); }
  constexpr decltype(auto) operator()(const M& m, face_t<M> f) const { return adj_f2p(m, f); }
} adj_facet2p{};

/// The verts of a facet, in cyclic order if it is a face: adj_e2v or adj_f2v.
inline constexpr struct adj_facet2v_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, edge_t<M> e) { requires dimension_v<M> == 2; adj_e2v(m, e); }
  constexpr decltype(auto) operator()(const M& m, edge_t<M> e) const { return adj_e2v(m, e); }
  template<class M>
    requires requires(const M& m, face_t<M> f) { requires dimension_v<M> == 3; adj_f2v(m, f); }
  constexpr decltype(auto) operator()(const M& m, face_t<M> f) const { return adj_f2v(m, f); }
} adj_facet2v{};

namespace detail {

/// The polys of a facet without one of them.
template<class M>
class polys_without {
  using poly = poly_t<M>;
  using ring = decltype(adj_facet2p(std::declval<const M&>(), std::declval<facet_t<M>>()));
  using base_iterator = decltype(std::declval<const std::remove_reference_t<ring>&>().begin());
  using last = decltype(std::declval<const std::remove_reference_t<ring>&>().end());

  ring polys_;
  poly left_out_;

 public:
  class sentinel {
    friend class polys_without;
    last end_;
    constexpr explicit sentinel(const last& end) : end_(end) {}
  };
  class iterator {
    const polys_without* r_;
    base_iterator it_;
    constexpr bool is_left_out() const {
      const poly p = *it_;
      return p == r_->left_out_;
    }
    constexpr void skip() {
      while (it_ != r_->polys_.end() && is_left_out()) ++it_;
    }

   public:
    constexpr explicit iterator(const polys_without& r) : r_(&r), it_(r.polys_.begin()) { skip(); }
    constexpr poly operator*() const { return *it_; }
    constexpr iterator& operator++() {
      ++it_;
      skip();
      return *this;
    }
    constexpr bool operator!=(const sentinel& s) const { return it_ != s.end_; }
  };

  constexpr polys_without(const M& m, const poly& p, const facet_t<M>& x) : polys_(adj_facet2p(m, x)), left_out_(p) {}
  polys_without(const polys_without&) = delete;

  constexpr iterator begin() const { return iterator(*this); }
  constexpr sentinel end() const { return sentinel(polys_.end()); }
};

}  // namespace detail

/// The polys of facet x other than p.
/// Needs:  adj_facet2p; p is a poly of x.
/// Result: a range of polys: none at the boundary, one in the interior of a manifold, several at a non-manifold facet.
/// Cost:   proportional to the polys of x; nothing is allocated.
/// Errors: none.
inline constexpr struct other_polys_verb : detail::verb {
  using verb::operator();
  template<class M>
    requires requires(const M& m, facet_t<M> x) { adj_facet2p(m, x); }
  constexpr auto operator()(const M& m, poly_t<M> p, facet_t<M> x) const { return detail::polys_without<M>(m, p, x); }
} other_polys{};

/// Whether an element is on the boundary: a facet with exactly one poly, or a vert, edge or poly that has such a facet.
/// Needs:  AnyMesh M; x is an element of m.
/// Result: true or false. False for facets without polys and for facets with three polys or more.
/// Cost:   O(1) for a facet; else proportional to the facets of x.
/// Errors: none.
inline constexpr struct is_boundary_verb : detail::verb {
  using verb::operator();
  template<AnyMesh M> constexpr bool operator()(const M& m, vert_t<M> v) const { return at_vert(m, v); }
  template<AnyMesh M> constexpr bool operator()(const M& m, edge_t<M> e) const { return at_edge(m, e); }
  template<VolumeMesh M> constexpr bool operator()(const M& m, face_t<M> f) const { return at_facet(m, f); }
  template<AnyMesh M> constexpr bool operator()(const M& m, poly_t<M> p) const { return any(m, adj_p2facet(m, p)); }

 private:
  template<class M>
  static constexpr bool at_facet(const M& m, const facet_t<M>& x) { return detail::is_single(adj_facet2p(m, x)); }
  template<class M, class R>
  static constexpr bool any(const M& m, const R& some) {
    for (const facet_t<M> x : some)
      if (at_facet(m, x)) return true;
    return false;
  }
  // The facets at a vert have different names, and an edge is itself a facet of a surface.
  template<SurfaceMesh M>
  static constexpr bool at_vert(const M& m, const vert_t<M>& v) {
    return any(m, adj_v2e(m, v));
  }
  template<VolumeMesh M> static constexpr bool at_vert(const M& m, const vert_t<M>& v) { return any(m, adj_v2f(m, v)); }
  template<SurfaceMesh M> static constexpr bool at_edge(const M& m, const edge_t<M>& e) { return at_facet(m, e); }
  template<VolumeMesh M> static constexpr bool at_edge(const M& m, const edge_t<M>& e) { return any(m, adj_e2f(m, e)); }
} is_boundary{};

}  // namespace concino
