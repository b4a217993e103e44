// HalfedgeLinks: the links between half-edges from which halfedge_kernel derives all adjacencies; halfedge_kernel.hpp
// lists its members.
#pragma once

#include <concino/concepts/requirement.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace concino {

namespace requirement {

template<class K> concept names_link_types = requires {
  typename K::vert;
  typename K::edge;
  typename K::poly;
  typename K::halfedge;
};
template<class K>
concept has_link_types = names_link_types<K> && std::regular<typename K::vert> && std::regular<typename K::edge> &&
    std::regular<typename K::poly> && std::regular<typename K::halfedge>;
struct link_types_requirement {
  template<class K, class M> static constexpr bool holds = has_link_types<K>;
  template<class K, class M> static consteval void explain() {
    static_assert(!names_link_types<K> || detail::missing<K, M>, "concino: the types are there, but one of them is not std::regular: it cannot be copied, default-constructed or compared by ==");
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs using vert, edge, poly, halfedge = four std::regular types");
  }
};

template<class K, class M> concept has_next = requires(const M& m, typename K::halfedge h) {
  { K::next(m, h) } -> std::convertible_to<typename K::halfedge>;
};
struct next_requirement {
  template<class K, class M> static constexpr bool holds = has_next<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(detail::explain_result<requires { &K::next; },
                                         requires(const M& m, typename K::halfedge h) { K::next(m, h); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs static halfedge next(const M&, halfedge); along the poly, or along the border");
  }
};

template<class K, class M> concept has_opposite = requires(const M& m, typename K::halfedge h) {
  { K::opposite(m, h) } -> std::convertible_to<typename K::halfedge>;
};
struct opposite_requirement {
  template<class K, class M> static constexpr bool holds = has_opposite<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(detail::explain_result<requires { &K::opposite; },
                                         requires(const M& m, typename K::halfedge h) { K::opposite(m, h); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs static halfedge opposite(const M&, halfedge); the other half-edge of the edge");
  }
};

template<class K, class M> concept has_target = requires(const M& m, typename K::halfedge h) {
  { K::target(m, h) } -> std::convertible_to<typename K::vert>;
};
struct target_requirement {
  template<class K, class M> static constexpr bool holds = has_target<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(detail::explain_result<requires { &K::target; },
                                         requires(const M& m, typename K::halfedge h) { K::target(m, h); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs static vert target(const M&, halfedge); the vert that the half-edge leads to");
  }
};

template<class K> concept lacks_border_halfedges = requires { requires !K::has_border_halfedges; };
template<class K, class M>
concept has_has_opposite = !lacks_border_halfedges<K> || requires(const M& m, typename K::halfedge h) {
  { K::has_opposite(m, h) } -> std::convertible_to<bool>;
};
struct has_opposite_requirement {
  template<class K, class M> static constexpr bool holds = has_has_opposite<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(
        detail::explain_result<requires { &K::has_opposite; },
                               requires(const M& m, typename K::halfedge h) { K::has_opposite(m, h); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks without border half-edges needs static bool has_opposite(const M&, halfedge); false where the edge has no other poly");
  }
};

template<class K, class M>
concept has_is_border = lacks_border_halfedges<K> || requires(const M& m, typename K::halfedge h) {
  { K::is_border(m, h) } -> std::convertible_to<bool>;
};
struct is_border_requirement {
  template<class K, class M> static constexpr bool holds = has_is_border<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(detail::explain_result<requires { &K::is_border; },
                                         requires(const M& m, typename K::halfedge h) { K::is_border(m, h); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs static bool is_border(const M&, halfedge); whether the half-edge has no poly; where the border has no half-edges: static constexpr bool has_border_halfedges = false; and has_opposite");
  }
};

template<class K, class M> concept has_poly_of = requires(const M& m, typename K::halfedge h) {
  { K::poly_of(m, h) } -> std::convertible_to<typename K::poly>;
};
struct poly_of_requirement {
  template<class K, class M> static constexpr bool holds = has_poly_of<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(detail::explain_result<requires { &K::poly_of; },
                                         requires(const M& m, typename K::halfedge h) { K::poly_of(m, h); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs static poly poly_of(const M&, halfedge); called only for half-edges that are not at the border");
  }
};

template<class K, class M> concept has_edge_of = requires(const M& m, typename K::halfedge h) {
  { K::edge_of(m, h) } -> std::convertible_to<typename K::edge>;
};
struct edge_of_requirement {
  template<class K, class M> static constexpr bool holds = has_edge_of<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(detail::explain_result<requires { &K::edge_of; },
                                         requires(const M& m, typename K::halfedge h) { K::edge_of(m, h); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs static edge edge_of(const M&, halfedge); the edge that the half-edge belongs to");
  }
};

template<class K, class M> concept has_is_isolated = requires(const M& m, typename K::vert v) {
  { K::is_isolated(m, v) } -> std::convertible_to<bool>;
};
struct is_isolated_requirement {
  template<class K, class M> static constexpr bool holds = has_is_isolated<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(detail::explain_result<requires { &K::is_isolated; },
                                         requires(const M& m, typename K::vert v) { K::is_isolated(m, v); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs static bool is_isolated(const M&, vert); whether the vert has no edge");
  }
};

template<class K, class M> concept has_halfedge_of_vert = requires(const M& m, typename K::vert v) {
  { K::halfedge_of(m, v) } -> std::convertible_to<typename K::halfedge>;
};
struct halfedge_of_vert_requirement {
  template<class K, class M> static constexpr bool holds = has_halfedge_of_vert<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(
        detail::explain_result<false, requires(const M& m, typename K::vert v) { K::halfedge_of(m, v); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs static halfedge halfedge_of(const M&, vert); one that leaves the vert");
  }
};

template<class K, class M> concept has_halfedge_of_edge = requires(const M& m, typename K::edge e) {
  { K::halfedge_of(m, e) } -> std::convertible_to<typename K::halfedge>;
};
struct halfedge_of_edge_requirement {
  template<class K, class M> static constexpr bool holds = has_halfedge_of_edge<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(
        detail::explain_result<false, requires(const M& m, typename K::edge e) { K::halfedge_of(m, e); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs static halfedge halfedge_of(const M&, edge); either of the two");
  }
};

template<class K, class M> concept has_halfedge_of_poly = requires(const M& m, typename K::poly p) {
  { K::halfedge_of(m, p) } -> std::convertible_to<typename K::halfedge>;
};
struct halfedge_of_poly_requirement {
  template<class K, class M> static constexpr bool holds = has_halfedge_of_poly<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(
        detail::explain_result<false, requires(const M& m, typename K::poly p) { K::halfedge_of(m, p); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs static halfedge halfedge_of(const M&, poly); one along the poly");
  }
};

template<class K, class M> concept has_number_of_verts = requires(const M& m) {
  { K::num_verts(m) } -> std::convertible_to<std::size_t>;
};
struct number_of_verts_requirement {
  template<class K, class M> static constexpr bool holds = has_number_of_verts<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(
        detail::explain_result<requires { &K::num_verts; }, requires(const M& m) { K::num_verts(m); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs static std::size_t num_verts(const M&); how many verts there are");
  }
};

template<class K, class M> concept has_number_of_edges = requires(const M& m) {
  { K::num_edges(m) } -> std::convertible_to<std::size_t>;
};
struct number_of_edges_requirement {
  template<class K, class M> static constexpr bool holds = has_number_of_edges<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(
        detail::explain_result<requires { &K::num_edges; }, requires(const M& m) { K::num_edges(m); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs static std::size_t num_edges(const M&); how many edges there are");
  }
};

template<class K, class M> concept has_number_of_polys = requires(const M& m) {
  { K::num_polys(m) } -> std::convertible_to<std::size_t>;
};
struct number_of_polys_requirement {
  template<class K, class M> static constexpr bool holds = has_number_of_polys<K, M>;
  template<class K, class M> static consteval void explain() {
    static_assert(
        detail::explain_result<requires { &K::num_polys; }, requires(const M& m) { K::num_polys(m); }, K, M>());
    static_assert(detail::missing<K, M>, "concino: HalfedgeLinks needs static std::size_t num_polys(const M&); how many polys there are");
  }
};

using halfedge_links_requirements =
    list<link_types_requirement, next_requirement, opposite_requirement, target_requirement, has_opposite_requirement,
         is_border_requirement, poly_of_requirement, edge_of_requirement, is_isolated_requirement,
         halfedge_of_vert_requirement, halfedge_of_edge_requirement, halfedge_of_poly_requirement,
         number_of_verts_requirement, number_of_edges_requirement, number_of_polys_requirement>;

}  // namespace requirement

/// K has the links of the half-edges of M: the members listed in halfedge_kernel.hpp.
template<class K, class M>
concept HalfedgeLinks =
    requirement::has_link_types<K> && requirement::has_next<K, M> && requirement::has_opposite<K, M> &&
    requirement::has_target<K, M> && requirement::has_has_opposite<K, M> && requirement::has_is_border<K, M> &&
    requirement::has_poly_of<K, M> && requirement::has_edge_of<K, M> && requirement::has_is_isolated<K, M> &&
    requirement::has_halfedge_of_vert<K, M> && requirement::has_halfedge_of_edge<K, M> &&
    requirement::has_halfedge_of_poly<K, M> && requirement::has_number_of_verts<K, M> &&
    requirement::has_number_of_edges<K, M> && requirement::has_number_of_polys<K, M>;

/// Fails to compile with one sentence that names the first thing K lacks to be HalfedgeLinks of M and what to write.
template<class K, class M>
consteval void explain_halfedge_links() {
  if constexpr (!HalfedgeLinks<K, M>)
    requirement::first_missing<requirement::halfedge_links_requirements, K, M>::template explain<K, M>();
}

}  // namespace concino
