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

template<class M> concept has_vert = std::regular<vert_t<M>>;
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
consteval void explain_primal_graph();

}  // namespace concino

