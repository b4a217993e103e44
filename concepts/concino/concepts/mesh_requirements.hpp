// The requirements that surfaces and volumes share: a dimension, edges and the adjacencies of both.
#pragma once

#include <concino/concepts/dual_graph.hpp>
#include <concino/concepts/primal_graph.hpp>

namespace concino::requirement {

template<class M> concept has_edge = requires { typename edge_t<M>; } && std::regular<edge_t<M>>;
template<class M> concept has_edges = requires(const std::remove_cvref_t<M>& m) { { traits<M>::edges(m) } -> ElementRange<edge_t<M>>; };
template<class M> concept has_num_edges = requires(const std::remove_cvref_t<M>& m) { { traits<M>::num_edges(m) } -> std::convertible_to<std::size_t>; };
template<class M> concept has_edge_index_bound = requires(const std::remove_cvref_t<M>& m) { { traits<M>::edge_index_bound(m) } -> std::convertible_to<std::size_t>; };
template<class M> concept has_edge_index_of = requires(const std::remove_cvref_t<M>& m, edge_t<M> e) { { traits<M>::index_of(m, e) } -> std::convertible_to<std::size_t>; };
template<class M> concept has_adj_e2v = requires(const std::remove_cvref_t<M>& m, edge_t<M> e) { { traits<M>::adj_e2v(m, e) } -> ElementRange<vert_t<M>>; };
template<class M> concept has_adj_e2p = requires(const std::remove_cvref_t<M>& m, edge_t<M> e) { { traits<M>::adj_e2p(m, e) } -> ElementRange<poly_t<M>>; };
template<class M> concept has_adj_v2e = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) { { traits<M>::adj_v2e(m, v) } -> ElementRange<edge_t<M>>; };
template<class M> concept has_adj_v2p = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) { { traits<M>::adj_v2p(m, v) } -> ElementRange<poly_t<M>>; };
template<class M> concept has_adj_p2v = requires(const std::remove_cvref_t<M>& m, poly_t<M> p) { { traits<M>::adj_p2v(m, p) } -> ElementRange<vert_t<M>>; };
template<class M> concept has_adj_p2e = requires(const std::remove_cvref_t<M>& m, poly_t<M> p) { { traits<M>::adj_p2e(m, p) } -> ElementRange<edge_t<M>>; };

template<class M> concept is_surface = dimension_v<M> == 2;
template<class M> concept is_volume = dimension_v<M> == 3;
template<class M> concept has_distinct_descriptors =
    !std::same_as<vert_t<M>, edge_t<M>> && !std::same_as<vert_t<M>, poly_t<M>> && !std::same_as<edge_t<M>, poly_t<M>>;

/// A promise that a type may make, `static constexpr bool edges_in_order = true;`, so that algorithms on its polys need not search:
///   SM7  the k-th edge of adj_p2e(p) joins the k-th vert of adj_p2v(p) and the next one, the last the last and the first
///   VM8  where polys are tets by type, the edges of adj_p2e(p) join the verts 01 02 03 12 13 23 of adj_p2v(p)
/// Of other volumes it says nothing.
template<class M>
concept promises_edges_in_order = requires { requires traits<M>::edges_in_order; } && (dimension_v<M> == 2 || arity_v<M> == 4);

}  // namespace concino::requirement

// Whoever includes the parts can ask for what is missing: explain_surface_mesh<M>(), explain_volume_mesh<M>().
#include <concino/concepts/surface_mesh.hpp>
#include <concino/concepts/volume_mesh.hpp>
