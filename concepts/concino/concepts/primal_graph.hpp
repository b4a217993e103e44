// PrimalGraph: verts, joined by edges. The concept of shortest paths, searches and everything else that never asks for a poly.
//
// Laws (the compiler cannot check them; check_laws of <concino/validate.hpp> does):
//   PG1  index_of is below vert_index_bound and differs between verts
//   PG2  walking verts(m) meets num_verts(m) verts, each once, and the same ones when walked again; `contains`, where offered, agrees
//   PG3  w is in adj_v2v(v) exactly if v is in adj_v2v(w)
//   PG4  adj_v2v(v) holds neither v itself nor any vert twice, and only verts of m
#pragma once

#include <concino/concepts/mesh_traits.hpp>

namespace concino {

namespace requirement {

template<class M> concept has_vert = requires { typename vert_t<M>; } && std::regular<vert_t<M>>;
template<class M> concept has_verts = requires(const std::remove_cvref_t<M>& m) { { traits<M>::verts(m) } -> ElementRange<vert_t<M>>; };
template<class M> concept has_num_verts = requires(const std::remove_cvref_t<M>& m) { { traits<M>::num_verts(m) } -> std::convertible_to<std::size_t>; };
template<class M> concept has_vert_index_bound = requires(const std::remove_cvref_t<M>& m) { { traits<M>::vert_index_bound(m) } -> std::convertible_to<std::size_t>; };
template<class M> concept has_vert_index_of = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) { { traits<M>::index_of(m, v) } -> std::convertible_to<std::size_t>; };
template<class M> concept has_adj_v2v = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) { { traits<M>::adj_v2v(m, v) } -> ElementRange<vert_t<M>>; };

}  // namespace requirement

template<class M>
concept PrimalGraph = requirement::is_adapted<M> && requirement::has_vert<M> && requirement::has_verts<M> && requirement::has_num_verts<M> &&
                      requirement::has_vert_index_bound<M> && requirement::has_vert_index_of<M> && requirement::has_adj_v2v<M>;

/// Fails to compile with one sentence that names the first thing M lacks to be a PrimalGraph and what to write.
template<class M>
consteval void explain_primal_graph() {
  using detail::missing;
  // One line per message, so that compilers show it in one.
  // clang-format off
  if constexpr (!requirement::is_adapted<M>)
    static_assert(missing<M>, "concino: PrimalGraph: " CONCINO_NO_TRAITS);
  else if constexpr (!requirement::has_vert<M>)
    static_assert(missing<M>, "concino: PrimalGraph needs mesh_traits<M>::vert: using vert = a std::regular type; names one vert");
  else if constexpr (!requirement::has_verts<M>)
    static_assert(detail::explain_range<vert_t<M>, decltype(verts), const std::remove_cvref_t<M>&>() && missing<M>, "concino: PrimalGraph needs mesh_traits<M>::verts: static ElementRange<vert> verts(const M&); all verts");
  else if constexpr (!requirement::has_num_verts<M>)
    static_assert(missing<M>, "concino: PrimalGraph needs mesh_traits<M>::num_verts: static std::size_t num_verts(const M&); how many verts the walk meets");
  else if constexpr (!requirement::has_vert_index_bound<M>)
    static_assert(missing<M>, "concino: PrimalGraph needs mesh_traits<M>::vert_index_bound: static std::size_t vert_index_bound(const M&); exclusive bound of index_of");
  else if constexpr (!requirement::has_vert_index_of<M>)
    static_assert(missing<M>, "concino: PrimalGraph needs mesh_traits<M>::index_of: static std::size_t index_of(const M&, vert); below vert_index_bound, different for different verts");
  else if constexpr (!requirement::has_adj_v2v<M>)
    static_assert(detail::explain_range<vert_t<M>, decltype(adj_v2v), const std::remove_cvref_t<M>&, vert_t<M>>() && missing<M>, "concino: PrimalGraph needs mesh_traits<M>::adj_v2v: static ElementRange<vert> adj_v2v(const M&, vert); the verts joined to a vert by an edge");
  else static_assert(PrimalGraph<M>);
  // clang-format on
}

}  // namespace concino

