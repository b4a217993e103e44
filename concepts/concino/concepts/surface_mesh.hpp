// SurfaceMesh: verts, edges and polygons with the adjacencies between them.
//
// Laws, in addition to those of both graphs:
//   SM1  index_of of edges is below edge_index_bound and differs; iterating over edges(m) yields num_edges(m), each
//        once
//   SM2  adj_e2v(e) is two different verts, in the same order each time, adj_v2e mirrors it, and adj_v2v(v) is the far
//        ends of adj_v2e(v)
//   SM3  adj_p2v(p) is the polygon in cyclic order: two consecutive verts, also the last and the first, are the ends of
//        one of adj_p2e(p); no vert twice, as many edges as verts
//   SM4  adj_e2p mirrors adj_p2e and adj_v2p mirrors adj_p2v, nothing twice
//   SM5  adj_p2p(p) is the polys that share an edge with p
//   SM6  if the type fixes the arity, adj_p2v(p) is that many verts
//   SM7  the k-th edge of adj_p2e(p) joins the k-th vert of adj_p2v(p) and the next one; the last edge joins the last
//        vert and the first
//
// A model whose lists have another order declares static constexpr bool edges_in_order = false; in its traits, and the
// verbs sort.
#pragma once

#include <concino/concepts/mesh_requirements.hpp>

namespace concino {

namespace requirement {

using surface_mesh_requirements =
    list<traits_requirements, surface_dimension_requirement, distinct_descriptors_requirement, mesh_requirements>;
using tri_mesh_requirements = list<surface_mesh_requirements, arity_3_requirement>;
using quad_mesh_requirements = list<surface_mesh_requirements, arity_4_requirement>;

}  // namespace requirement

template<class M>
concept SurfaceMesh = PrimalGraph<M> && DualGraph<M> && requirement::is_surface<M> && requirement::has_edge<M> &&
    requirement::has_distinct_descriptors<M> && requirement::has_edges<M> && requirement::has_num_edges<M> &&
    requirement::has_edge_index_bound<M> && requirement::has_edge_index_of<M> && requirement::has_adj_e2v<M> &&
    requirement::has_adj_e2p<M> && requirement::has_adj_v2e<M> && requirement::has_adj_v2p<M> &&
    requirement::has_adj_p2v<M> && requirement::has_adj_p2e<M>;

/// Surfaces of triangles, of quads, if the type fixes that at compile time.
template<class M> concept TriMesh = SurfaceMesh<M> && requirement::has_arity_3<M>;
template<class M> concept QuadMesh = SurfaceMesh<M> && requirement::has_arity_4<M>;

/// Fails to compile with one sentence that names the first thing M lacks to be a SurfaceMesh and what to write.
template<class M>
consteval void explain_surface_mesh() {
  if constexpr (!SurfaceMesh<M>)
    requirement::first_missing<requirement::surface_mesh_requirements, M>::template explain<M>();
}

/// Fails to compile with one sentence that names the first thing M lacks to be a TriMesh and what to write.
template<class M>
consteval void explain_tri_mesh() {
  if constexpr (!TriMesh<M>) requirement::first_missing<requirement::tri_mesh_requirements, M>::template explain<M>();
}

/// Fails to compile with one sentence that names the first thing M lacks to be a QuadMesh and what to write.
template<class M>
consteval void explain_quad_mesh() {
  if constexpr (!QuadMesh<M>) requirement::first_missing<requirement::quad_mesh_requirements, M>::template explain<M>();
}

}  // namespace concino
