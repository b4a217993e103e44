// DualGraph: polys as nodes, joined where they share an edge (surface) or a face (volume). Algorithms that only visit
// neighbouring polys require this concept, so that they run on polygons and polyhedra alike.
//
// Laws:
//   DG1  index_of is below poly_index_bound and differs between polys
//   DG2  iterating over polys(m) yields num_polys(m) polys, each once, and the same ones on every pass; `contains`, if
//        defined, agrees
//   DG3  q is in adj_p2p(p) exactly if p is in adj_p2p(q)
//   DG4  adj_p2p(p) contains neither p itself nor any poly twice, and only polys of m
#pragma once

#include <concino/concepts/mesh_traits.hpp>

namespace concino {

namespace requirement {

template<class M> concept has_poly = requires { typename poly_t<M>; } && std::regular<poly_t<M>>;
struct poly_requirement {
  template<class M> static constexpr bool holds = has_poly<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_regular<poly_t, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs poly: using poly = a std::regular type; names one poly");
  }
};

template<class M> concept has_polys = requires(const std::remove_cvref_t<M>& m) {
  { traits<M>::polys(m) } -> ElementRange<poly_t<M>>;
};
struct polys_requirement {
  template<class M> static constexpr bool holds = has_polys<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::polys; }, poly_t<M>, polys_verb, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs polys: static ElementRange<poly> polys(const M&); all polys");
  }
};

template<class M> concept has_num_polys = requires(const std::remove_cvref_t<M>& m) {
  { traits<M>::num_polys(m) } -> std::convertible_to<std::size_t>;
};
struct num_polys_requirement {
  template<class M> static constexpr bool holds = has_num_polys<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<requires { &traits<M>::num_polys; }, num_polys_verb, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs num_polys: static std::size_t num_polys(const M&); the number of polys in polys(m)");
  }
};

template<class M> concept has_poly_index_bound = requires(const std::remove_cvref_t<M>& m) {
  { traits<M>::poly_index_bound(m) } -> std::convertible_to<std::size_t>;
};
struct poly_index_bound_requirement {
  template<class M> static constexpr bool holds = has_poly_index_bound<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<requires { &traits<M>::poly_index_bound; }, poly_index_bound_verb, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs poly_index_bound: static std::size_t poly_index_bound(const M&); exclusive bound of index_of");
  }
};

template<class M> concept has_poly_index_of = requires(const std::remove_cvref_t<M>& m, poly_t<M> p) {
  { traits<M>::index_of(m, p) } -> std::convertible_to<std::size_t>;
};
struct poly_index_of_requirement {
  template<class M> static constexpr bool holds = has_poly_index_of<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<false, index_of_verb, M, poly_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs index_of: static std::size_t index_of(const M&, poly); below poly_index_bound, different for different polys");
  }
};

template<class M> concept has_adj_p2p = requires(const std::remove_cvref_t<M>& m, poly_t<M> p) {
  { traits<M>::adj_p2p(m, p) } -> ElementRange<poly_t<M>>;
};
struct adj_p2p_requirement {
  template<class M> static constexpr bool holds = has_adj_p2p<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_p2p; }, poly_t<M>, adj_p2p_verb, M, poly_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_p2p: static ElementRange<poly> adj_p2p(const M&, poly); the polys that share an edge (surface) or a face (volume) with the poly");
  }
};

using dual_graph_requirements = list<traits_requirements, poly_requirement, polys_requirement, num_polys_requirement,
                                     poly_index_bound_requirement, poly_index_of_requirement, adj_p2p_requirement>;

}  // namespace requirement

template<class M>
concept DualGraph = requirement::is_adapted<M> && requirement::has_poly<M> && requirement::has_polys<M> &&
    requirement::has_num_polys<M> && requirement::has_poly_index_bound<M> && requirement::has_poly_index_of<M> &&
    requirement::has_adj_p2p<M>;

/// Fails to compile with one sentence that names the first thing M lacks to be a DualGraph and what to write.
template<class M>
consteval void explain_dual_graph() {
  if constexpr (!DualGraph<M>)
    requirement::first_missing<requirement::dual_graph_requirements, M>::template explain<M>();
}

}  // namespace concino
