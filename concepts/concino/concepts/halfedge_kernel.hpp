// halfedge_kernel: the base class of mesh_traits for half-edge meshes. Write about ten one-line functions that link the
// half-edges, and inherit all adjacencies.
//
//   struct my_links {
//     using vert = ..., edge = ..., poly = ..., halfedge = ...;         // descriptors, std::regular
//     static halfedge next(const my_mesh& m, halfedge h);               // along the poly, or along the border
//     static halfedge opposite(const my_mesh& m, halfedge h);
//     static vert target(const my_mesh& m, halfedge h);
//     static bool is_border(const my_mesh& m, halfedge h);              // has h no poly?
//     static poly poly_of(const my_mesh& m, halfedge h);                // called only if h is not at the border
//     static edge edge_of(const my_mesh& m, halfedge h);
//     static bool is_isolated(const my_mesh& m, vert v);                // has v no edge?
//     static halfedge halfedge_of(const my_mesh& m, vert v);            // one that leaves v; called only if v is not
//                                                                       isolated
//     static halfedge halfedge_of(const my_mesh& m, edge e);            // either of the two
//     static halfedge halfedge_of(const my_mesh& m, poly p);            // one along p
//     static std::size_t num_verts(const my_mesh& m);                   // num_edges, num_polys alike
//     // If the border has no half-edges, declare so. has_opposite then replaces is_border, and opposite is called only
//     // if it is true:
//     //   static constexpr bool has_border_halfedges = false;
//     //   static bool has_opposite(const my_mesh& m, halfedge h);
//     //   static halfedge previous(const my_mesh& m, halfedge h);         // optional; otherwise found by a walk along
//     //                                                                   the poly
//     // verts(m), vert_index_bound(m), index_of(m, v) and so on: not needed if the descriptors are vert_id, edge_id
//     // and poly_id without gaps in their numbers.  point(m, v) for Embedded, arity, set_point ... as in any
//     // mesh_traits.
//   };
//   template<> struct concino::mesh_traits<my_mesh> : concino::halfedge_kernel<my_mesh, my_links> {};
//
// If something is missing, explain_surface_mesh<my_mesh>() does not compile, and its message says what to write next,
// also in the links; then explain_embedded<my_mesh>(). explain_halfedge_links<my_links, my_mesh>() checks the links
// alone.
//
// Half-edges can represent oriented manifolds only: surfaces whose edges have at most two polys, which have opposite
// directions along them. For other meshes use indexed_surface. The fans of polys at a vert must be linked by the border
// half-edges, from one fan to the next, as in OpenMesh and CGAL; without border half-edges a vert has one fan.
//
// Laws (check_laws names the first that is violated; assert_halfedge_links checks these alone):
//   HE1  repeated next from halfedge_of(p) yields half-edges of p only and returns to the start; at the border it
//        yields border half-edges
//   HE2  two verts are joined by at most two half-edges with polys, and by two only in opposite directions
//   HE3  opposite(h) is another half-edge, at the border too, whose opposite is h; edge_of is the same edge for both,
//        halfedge_of one of them
//   HE4  repeated next(opposite(h)) from halfedge_of(v) yields every half-edge that leaves v and returns to the start
#pragma once

#include <concino/concepts/requirement.hpp>  // first, so that compilers list few headers before the message

#include <concino/concepts/halfedge_links.hpp>
#include <concino/concepts/detail/halfedge_rings.hpp>
#include <concino/concepts/mesh.hpp>

namespace concino {

/// Derives mesh_traits from links: mesh_traits<M> inherits from it.
/// Cost: every range takes time proportional to its length, adj_p2p also to the lengths of the neighbouring polys;
/// nothing is stored. Without border half-edges and without `previous`, a vert at the border costs the size of the
/// polys there.
template<class M, class K>
struct halfedge_kernel : K {
  static constexpr int dimension = 2;
  using base_requirements = requirement::bound<requirement::halfedge_links_requirements, K, M>;
  using vert = typename K::vert;
  using edge = typename K::edge;
  using poly = typename K::poly;
  using halfedge_links = detail::links_with_border<M, K>;

 private:
  using L = halfedge_links;
  template<class X, class Tag> static constexpr bool is_id = std::same_as<X, id<Tag>>;
  template<detail::ring_kind Ring> using ring = detail::halfedge_ring<M, L, Ring>;

 public:
  static decltype(auto) verts(const M& m)
    requires(requires { K::verts(m); } || (is_id<vert, vert_tag> && requirement::has_number_of_verts<K, M>))
  {
    if constexpr (requires { K::verts(m); }) return K::verts(m);
    else return id_range<vert>(K::num_verts(m));
  }
  static decltype(auto) edges(const M& m)
    requires(requires { K::edges(m); } || (is_id<edge, edge_tag> && requirement::has_number_of_edges<K, M>))
  {
    if constexpr (requires { K::edges(m); }) return K::edges(m);
    else return id_range<edge>(K::num_edges(m));
  }
  static decltype(auto) polys(const M& m)
    requires(requires { K::polys(m); } || (is_id<poly, poly_tag> && requirement::has_number_of_polys<K, M>))
  {
    if constexpr (requires { K::polys(m); }) return K::polys(m);
    else return id_range<poly>(K::num_polys(m));
  }
  static std::size_t vert_index_bound(const M& m)
    requires(requires { K::vert_index_bound(m); } || (is_id<vert, vert_tag> && requirement::has_number_of_verts<K, M>))
  {
    if constexpr (requires { K::vert_index_bound(m); }) return K::vert_index_bound(m);
    else return K::num_verts(m);
  }
  static std::size_t edge_index_bound(const M& m)
    requires(requires { K::edge_index_bound(m); } || (is_id<edge, edge_tag> && requirement::has_number_of_edges<K, M>))
  {
    if constexpr (requires { K::edge_index_bound(m); }) return K::edge_index_bound(m);
    else return K::num_edges(m);
  }
  static std::size_t poly_index_bound(const M& m)
    requires(requires { K::poly_index_bound(m); } || (is_id<poly, poly_tag> && requirement::has_number_of_polys<K, M>))
  {
    if constexpr (requires { K::poly_index_bound(m); }) return K::poly_index_bound(m);
    else return K::num_polys(m);
  }
  template<class X>
    requires requires(const M& m, X x) { K::index_of(m, x); } ||
             is_id<X, vert_tag> || is_id<X, edge_tag> || is_id<X, poly_tag>
  static std::size_t index_of(const M& m, X x) {
    if constexpr (requires { K::index_of(m, x); }) return static_cast<std::size_t>(K::index_of(m, x));
    else return x.raw();
  }

  static auto adj_v2v(const M& m, vert v)
    requires HalfedgeLinks<K, M>
  {
    return ring<detail::ring_kind::v2v>::of(m, v);
  }
  static auto adj_v2e(const M& m, vert v)
    requires HalfedgeLinks<K, M>
  {
    return ring<detail::ring_kind::v2e>::of(m, v);
  }
  static auto adj_v2p(const M& m, vert v)
    requires HalfedgeLinks<K, M>
  {
    return ring<detail::ring_kind::v2p>::of(m, v);
  }
  static auto adj_p2v(const M& m, poly p)
    requires HalfedgeLinks<K, M>
  {
    return ring<detail::ring_kind::p2v>::of(m, p);
  }
  static auto adj_p2e(const M& m, poly p)
    requires HalfedgeLinks<K, M>
  {
    return ring<detail::ring_kind::p2e>::of(m, p);
  }
  static auto adj_p2p(const M& m, poly p)
    requires HalfedgeLinks<K, M>
  {
    return detail::halfedge_neighbours<M, L>(m, p);
  }
  static auto adj_e2v(const M& m, edge e)
    requires HalfedgeLinks<K, M>
  {
    const typename L::halfedge h = L::halfedge_of(m, e);
    return detail::up_to_two<vert>(L::target(m, L::opposite(m, h)), L::target(m, h));
  }
  static auto adj_e2p(const M& m, edge e)
    requires HalfedgeLinks<K, M>
  {
    const typename L::halfedge h = L::halfedge_of(m, e), o = L::opposite(m, h);
    const bool has_left = !L::is_border(m, h), has_right = !L::is_border(m, o);
    if (!has_left && !has_right) return detail::up_to_two<poly>();
    if (!has_right) return detail::up_to_two<poly>(L::poly_of(m, h));
    const poly right = L::poly_of(m, o);
    if (!has_left) return detail::up_to_two<poly>(right);
    const poly left = L::poly_of(m, h);
    return left == right ? detail::up_to_two<poly>(left) : detail::up_to_two<poly>(left, right);
  }
};

/// If the links lack one of their types, there are no members: M models no concept, and explain_surface_mesh<M>() says
/// what is missing.
template<class M, class K>
  requires(!requirement::names_link_types<K>)
struct halfedge_kernel<M, K> : K {
  static constexpr int dimension = 2;
  using base_requirements = requirement::bound<requirement::halfedge_links_requirements, K, M>;
};

}  // namespace concino
