// DualGraph: polys, joined where they share an edge (surface) or a face (volume). Algorithms that only step from poly to poly
// name this concept and so run on polygons and polyhedra alike.
//
// Laws:
//   DG1  index_of is below poly_index_bound and differs between polys
//   DG2  walking polys(m) meets num_polys(m) polys, each once, and the same ones when walked again; `contains`, where offered, agrees
//   DG3  q is in adj_p2p(p) exactly if p is in adj_p2p(q)
//   DG4  adj_p2p(p) holds neither p itself nor any poly twice, and only polys of m
#pragma once

#include <concino/concepts/mesh_traits.hpp>

namespace concino {

namespace requirement {

template<class M> concept has_poly = requires { typename poly_t<M>; } && std::regular<poly_t<M>>;
template<class M> concept has_polys = requires(const std::remove_cvref_t<M>& m) { { traits<M>::polys(m) } -> ElementRange<poly_t<M>>; };
template<class M> concept has_num_polys = requires(const std::remove_cvref_t<M>& m) { { traits<M>::num_polys(m) } -> std::convertible_to<std::size_t>; };
template<class M> concept has_poly_index_bound = requires(const std::remove_cvref_t<M>& m) { { traits<M>::poly_index_bound(m) } -> std::convertible_to<std::size_t>; };
template<class M> concept has_poly_index_of = requires(const std::remove_cvref_t<M>& m, poly_t<M> p) { { traits<M>::index_of(m, p) } -> std::convertible_to<std::size_t>; };
template<class M> concept has_adj_p2p = requires(const std::remove_cvref_t<M>& m, poly_t<M> p) { { traits<M>::adj_p2p(m, p) } -> ElementRange<poly_t<M>>; };

}  // namespace requirement

template<class M>
concept DualGraph = requirement::is_adapted<M> && requirement::has_poly<M> && requirement::has_polys<M> && requirement::has_num_polys<M> &&
                    requirement::has_poly_index_bound<M> && requirement::has_poly_index_of<M> && requirement::has_adj_p2p<M>;

/// Fails to compile with one sentence that names the first thing M lacks to be a DualGraph and what to write.
template<class M>
consteval void explain_dual_graph() {
  using detail::missing;
  // One line per message, so that compilers show it in one.
  // clang-format off
  if constexpr (!requirement::is_adapted<M>)
    static_assert(missing<M>, "concino: DualGraph: " CONCINO_NO_TRAITS);
  else if constexpr (!requirement::has_poly<M>)
    static_assert(missing<M>, "concino: DualGraph needs mesh_traits<M>::poly: using poly = a std::regular type; names one poly");
  else if constexpr (!requirement::has_polys<M>)
    static_assert(detail::explain_range<poly_t<M>, decltype(polys), const std::remove_cvref_t<M>&>() && missing<M>, "concino: DualGraph needs mesh_traits<M>::polys: static ElementRange<poly> polys(const M&); all polys");
  else if constexpr (!requirement::has_num_polys<M>)
    static_assert(missing<M>, "concino: DualGraph needs mesh_traits<M>::num_polys: static std::size_t num_polys(const M&); how many polys the walk meets");
  else if constexpr (!requirement::has_poly_index_bound<M>)
    static_assert(missing<M>, "concino: DualGraph needs mesh_traits<M>::poly_index_bound: static std::size_t poly_index_bound(const M&); exclusive bound of index_of");
  else if constexpr (!requirement::has_poly_index_of<M>)
    static_assert(missing<M>, "concino: DualGraph needs mesh_traits<M>::index_of: static std::size_t index_of(const M&, poly); below poly_index_bound, different for different polys");
  else if constexpr (!requirement::has_adj_p2p<M>)
    static_assert(detail::explain_range<poly_t<M>, decltype(adj_p2p), const std::remove_cvref_t<M>&, poly_t<M>>() && missing<M>, "concino: DualGraph needs mesh_traits<M>::adj_p2p: static ElementRange<poly> adj_p2p(const M&, poly); the polys across an edge (surface) or a face (volume)");
  else static_assert(DualGraph<M>);
  // clang-format on
}

}  // namespace concino

