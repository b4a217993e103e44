// SurfaceMesh: verts, edges and polygons with the adjacencies between them.
//
// Laws, beside those of both graphs:
//   SM1  index_of of edges is below edge_index_bound and differs; walking edges(m) meets num_edges(m), each once
//   SM2  adj_e2v(e) is two different verts, adj_v2e mirrors it, and adj_v2v(v) is the far ends of adj_v2e(v)
//   SM3  adj_p2v(p) walks the polygon: each two verts that follow one another, the last and the first too, are the ends of one of
//        adj_p2e(p); no vert twice, as many edges as verts
//   SM4  adj_e2p mirrors adj_p2e and adj_v2p mirrors adj_p2v, nothing twice
//   SM5  adj_p2p(p) is the polys that share an edge with p
//   SM6  where the type fixes the arity, adj_p2v(p) is that many verts
//   SM7  where the type promises edges_in_order, see mesh_requirements.hpp
#pragma once

#include <concino/concepts/mesh_requirements.hpp>

namespace concino {

template<class M>
concept SurfaceMesh = PrimalGraph<M> && DualGraph<M> && requirement::is_surface<M> && requirement::has_edge<M> && requirement::has_distinct_descriptors<M> &&
                      requirement::has_edges<M> && requirement::has_num_edges<M> && requirement::has_edge_index_bound<M> && requirement::has_edge_index_of<M> &&
                      requirement::has_adj_e2v<M> && requirement::has_adj_e2p<M> && requirement::has_adj_v2e<M> && requirement::has_adj_v2p<M> &&
                      requirement::has_adj_p2v<M> && requirement::has_adj_p2e<M>;

/// Surfaces of triangles, of quads: known when compiling.
template<class M> concept TriMesh = SurfaceMesh<M> && arity_v<M> == 3;
template<class M> concept QuadMesh = SurfaceMesh<M> && arity_v<M> == 4;

/// Fails to compile with one sentence that names the first thing M lacks to be a SurfaceMesh and what to write.
template<class M>
consteval void explain_surface_mesh() {
  using detail::missing;
  // One line per message, so that compilers show it in one.
  // clang-format off
  if constexpr (!requirement::is_adapted<M>)
    static_assert(missing<M>, "concino: SurfaceMesh: " CONCINO_NO_TRAITS);
  else if constexpr (!requirement::is_surface<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::dimension: static constexpr int dimension = 2;");
  else if constexpr (requirement::has_vert<M> && requirement::has_poly<M> && requirement::has_edge<M> && !requirement::has_distinct_descriptors<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs vert, edge and poly of mesh_traits<M> to be different types; wrap those that are the same");
  else if constexpr (!requirement::has_vert<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::vert: using vert = a std::regular type; names one vert");
  else if constexpr (!requirement::has_verts<M>)
    static_assert(detail::explain_range<vert_t<M>, decltype(verts), const std::remove_cvref_t<M>&>() && missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::verts: static ElementRange<vert> verts(const M&); all verts");
  else if constexpr (!requirement::has_num_verts<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::num_verts: static std::size_t num_verts(const M&); how many verts the walk meets");
  else if constexpr (!requirement::has_vert_index_bound<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::vert_index_bound: static std::size_t vert_index_bound(const M&); exclusive bound of index_of");
  else if constexpr (!requirement::has_vert_index_of<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::index_of: static std::size_t index_of(const M&, vert); below vert_index_bound, different for different verts");
  else if constexpr (!requirement::has_adj_v2v<M>)
    static_assert(detail::explain_range<vert_t<M>, decltype(adj_v2v), const std::remove_cvref_t<M>&, vert_t<M>>() && missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::adj_v2v: static ElementRange<vert> adj_v2v(const M&, vert); the verts joined to a vert by an edge");
  else if constexpr (!requirement::has_poly<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::poly: using poly = a std::regular type; names one poly");
  else if constexpr (!requirement::has_polys<M>)
    static_assert(detail::explain_range<poly_t<M>, decltype(polys), const std::remove_cvref_t<M>&>() && missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::polys: static ElementRange<poly> polys(const M&); all polys");
  else if constexpr (!requirement::has_num_polys<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::num_polys: static std::size_t num_polys(const M&); how many polys the walk meets");
  else if constexpr (!requirement::has_poly_index_bound<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::poly_index_bound: static std::size_t poly_index_bound(const M&); exclusive bound of index_of");
  else if constexpr (!requirement::has_poly_index_of<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::index_of: static std::size_t index_of(const M&, poly); below poly_index_bound, different for different polys");
  else if constexpr (!requirement::has_adj_p2p<M>)
    static_assert(detail::explain_range<poly_t<M>, decltype(adj_p2p), const std::remove_cvref_t<M>&, poly_t<M>>() && missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::adj_p2p: static ElementRange<poly> adj_p2p(const M&, poly); the polys across an edge (surface) or a face (volume)");
  else if constexpr (!requirement::has_edge<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::edge: using edge = a std::regular type; names one edge");
  else if constexpr (!requirement::has_edges<M>)
    static_assert(detail::explain_range<edge_t<M>, decltype(edges), const std::remove_cvref_t<M>&>() && missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::edges: static ElementRange<edge> edges(const M&); all edges");
  else if constexpr (!requirement::has_num_edges<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::num_edges: static std::size_t num_edges(const M&); how many edges the walk meets");
  else if constexpr (!requirement::has_edge_index_bound<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::edge_index_bound: static std::size_t edge_index_bound(const M&); exclusive bound of index_of");
  else if constexpr (!requirement::has_edge_index_of<M>)
    static_assert(missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::index_of: static std::size_t index_of(const M&, edge); below edge_index_bound, different for different edges");
  else if constexpr (!requirement::has_adj_e2v<M>)
    static_assert(detail::explain_range<vert_t<M>, decltype(adj_e2v), const std::remove_cvref_t<M>&, edge_t<M>>() && missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::adj_e2v: static ElementRange<vert> adj_e2v(const M&, edge); the two ends of an edge");
  else if constexpr (!requirement::has_adj_e2p<M>)
    static_assert(detail::explain_range<poly_t<M>, decltype(adj_e2p), const std::remove_cvref_t<M>&, edge_t<M>>() && missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::adj_e2p: static ElementRange<poly> adj_e2p(const M&, edge); the polys at an edge");
  else if constexpr (!requirement::has_adj_v2e<M>)
    static_assert(detail::explain_range<edge_t<M>, decltype(adj_v2e), const std::remove_cvref_t<M>&, vert_t<M>>() && missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::adj_v2e: static ElementRange<edge> adj_v2e(const M&, vert); the edges at a vert");
  else if constexpr (!requirement::has_adj_v2p<M>)
    static_assert(detail::explain_range<poly_t<M>, decltype(adj_v2p), const std::remove_cvref_t<M>&, vert_t<M>>() && missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::adj_v2p: static ElementRange<poly> adj_v2p(const M&, vert); the polys at a vert");
  else if constexpr (!requirement::has_adj_p2v<M>)
    static_assert(detail::explain_range<vert_t<M>, decltype(adj_p2v), const std::remove_cvref_t<M>&, poly_t<M>>() && missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::adj_p2v: static ElementRange<vert> adj_p2v(const M&, poly); the verts of a poly in cyclic order");
  else if constexpr (!requirement::has_adj_p2e<M>)
    static_assert(detail::explain_range<edge_t<M>, decltype(adj_p2e), const std::remove_cvref_t<M>&, poly_t<M>>() && missing<M>, "concino: SurfaceMesh needs mesh_traits<M>::adj_p2e: static ElementRange<edge> adj_p2e(const M&, poly); the edges of a poly");
  else static_assert(SurfaceMesh<M>);
  // clang-format on
}

/// Fails to compile with one sentence that names the first thing M lacks to be a TriMesh and what to write.
template<class M>
consteval void explain_tri_mesh() {
  if constexpr (!SurfaceMesh<M>) explain_surface_mesh<M>();
  else if constexpr (!TriMesh<M>)
    static_assert(detail::missing<M>, "concino: TriMesh needs mesh_traits<M>::arity: static constexpr int arity = 3; every poly has 3 verts");
}

/// Fails to compile with one sentence that names the first thing M lacks to be a QuadMesh and what to write.
template<class M>
consteval void explain_quad_mesh() {
  if constexpr (!SurfaceMesh<M>) explain_surface_mesh<M>();
  else if constexpr (!QuadMesh<M>)
    static_assert(detail::missing<M>, "concino: QuadMesh needs mesh_traits<M>::arity: static constexpr int arity = 4; every poly has 4 verts");
}

}  // namespace concino

