// VolumeMesh: verts, edges, faces and polyhedra with the adjacencies between them.
//
// Laws, beside those of both graphs and SM1, SM2 (edges are as in a surface):
//   VM1  index_of of faces is below face_index_bound and differs; walking faces(m) meets num_faces(m), each once
//   VM2  adj_f2v(f) walks the face: each two verts that follow one another are the ends of one of adj_f2e(f); no vert twice, as many
//        edges as verts
//   VM3  adj_e2f mirrors adj_f2e, adj_v2f mirrors adj_f2v, adj_f2p mirrors adj_p2f, nothing twice
//   VM4  adj_p2v(p) and adj_p2e(p) are the verts and edges of p's faces, adj_v2p and adj_e2p mirror them, nothing twice
//   VM5  adj_p2p(p) is the polys that share a face with p
//   VM6  a poly each of whose edges lies in two of its faces is wound consistently: of these two one, turned outward, runs along the edge
//        and the other against it
//   VM7  where polys are tets or hexes by type, adj_p2v lists 4 or 8 verts in the standard order: the tet's faces are 0 2 1, 0 1 3,
//        0 3 2, 1 2 3, the hex's 0 3 2 1, 1 2 6 5, 4 5 6 7, 3 0 4 7, 0 1 5 4, 2 3 7 6, in any order
#pragma once

#include <concino/concepts/mesh_requirements.hpp>

namespace concino {

namespace requirement {

template<class M> concept has_face = std::regular<face_t<M>>;
template<class M> concept has_faces = requires(const std::remove_cvref_t<M>& m) { { traits<M>::faces(m) } -> ElementRange<face_t<M>>; };
template<class M> concept has_num_faces = requires(const std::remove_cvref_t<M>& m) { { traits<M>::num_faces(m) } -> std::convertible_to<std::size_t>; };
template<class M> concept has_face_index_bound = requires(const std::remove_cvref_t<M>& m) { { traits<M>::face_index_bound(m) } -> std::convertible_to<std::size_t>; };
template<class M> concept has_face_index_of = requires(const std::remove_cvref_t<M>& m, face_t<M> f) { { traits<M>::index_of(m, f) } -> std::convertible_to<std::size_t>; };
template<class M> concept has_adj_f2v = requires(const std::remove_cvref_t<M>& m, face_t<M> f) { { traits<M>::adj_f2v(m, f) } -> ElementRange<vert_t<M>>; };
template<class M> concept has_adj_f2e = requires(const std::remove_cvref_t<M>& m, face_t<M> f) { { traits<M>::adj_f2e(m, f) } -> ElementRange<edge_t<M>>; };
template<class M> concept has_adj_f2p = requires(const std::remove_cvref_t<M>& m, face_t<M> f) { { traits<M>::adj_f2p(m, f) } -> ElementRange<poly_t<M>>; };
template<class M> concept has_adj_v2f = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) { { traits<M>::adj_v2f(m, v) } -> ElementRange<face_t<M>>; };
template<class M> concept has_adj_e2f = requires(const std::remove_cvref_t<M>& m, edge_t<M> e) { { traits<M>::adj_e2f(m, e) } -> ElementRange<face_t<M>>; };
template<class M> concept has_adj_p2f = requires(const std::remove_cvref_t<M>& m, poly_t<M> p) { { traits<M>::adj_p2f(m, p) } -> ElementRange<face_t<M>>; };
template<class M> concept has_face_is_outward =
    requires(const std::remove_cvref_t<M>& m, poly_t<M> p, face_t<M> f) { { traits<M>::face_is_outward(m, p, f) } -> std::convertible_to<bool>; };
template<class M> concept has_distinct_faces =
    !std::same_as<vert_t<M>, face_t<M>> && !std::same_as<edge_t<M>, face_t<M>> && !std::same_as<poly_t<M>, face_t<M>>;

}  // namespace requirement

template<class M>
concept VolumeMesh = PrimalGraph<M> && DualGraph<M> && requirement::is_volume<M> && requirement::has_edge<M> && requirement::has_distinct_descriptors<M> &&
                     requirement::has_face<M> && requirement::has_distinct_faces<M> && requirement::has_edges<M> && requirement::has_num_edges<M> &&
                     requirement::has_edge_index_bound<M> && requirement::has_edge_index_of<M> && requirement::has_faces<M> && requirement::has_num_faces<M> &&
                     requirement::has_face_index_bound<M> && requirement::has_face_index_of<M> && requirement::has_adj_e2v<M> && requirement::has_adj_e2p<M> &&
                     requirement::has_adj_v2e<M> && requirement::has_adj_v2p<M> && requirement::has_adj_p2v<M> && requirement::has_adj_p2e<M> &&
                     requirement::has_adj_f2v<M> && requirement::has_adj_f2e<M> && requirement::has_adj_f2p<M> && requirement::has_adj_v2f<M> &&
                     requirement::has_adj_e2f<M> && requirement::has_adj_p2f<M> && requirement::has_face_is_outward<M>;

/// Volumes of tetrahedra, of hexahedra: known when compiling.
template<class M> concept TetMesh = VolumeMesh<M> && arity_v<M> == 4;
template<class M> concept HexMesh = VolumeMesh<M> && arity_v<M> == 8;

/// Fails to compile with one sentence that names the first thing M lacks to be a VolumeMesh and what to write.
template<class M>
consteval void explain_volume_mesh();

}  // namespace concino

