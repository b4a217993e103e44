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
//   VM8  where the type promises edges_in_order, see mesh_requirements.hpp
#pragma once

#include <concino/concepts/mesh_requirements.hpp>

namespace concino {

namespace requirement {

template<class M> concept has_face = requires { typename face_t<M>; } && std::regular<face_t<M>>;
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
consteval void explain_volume_mesh() {
  using detail::missing;
  // One line per message, so that compilers show it in one.
  // clang-format off
  if constexpr (!requirement::is_adapted<M>)
    static_assert(missing<M>, "concino: VolumeMesh: " CONCINO_NO_TRAITS);
  else if constexpr (!requirement::is_volume<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::dimension: static constexpr int dimension = 3;");
  else if constexpr (requirement::has_vert<M> && requirement::has_poly<M> && requirement::has_edge<M> && !requirement::has_distinct_descriptors<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs vert, edge and poly of mesh_traits<M> to be different types; wrap those that are the same");
  else if constexpr (!requirement::has_vert<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::vert: using vert = a std::regular type; names one vert");
  else if constexpr (!requirement::has_verts<M>)
    static_assert(detail::explain_range<vert_t<M>, decltype(verts), const std::remove_cvref_t<M>&>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::verts: static ElementRange<vert> verts(const M&); all verts");
  else if constexpr (!requirement::has_num_verts<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::num_verts: static std::size_t num_verts(const M&); how many verts the walk meets");
  else if constexpr (!requirement::has_vert_index_bound<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::vert_index_bound: static std::size_t vert_index_bound(const M&); exclusive bound of index_of");
  else if constexpr (!requirement::has_vert_index_of<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::index_of: static std::size_t index_of(const M&, vert); below vert_index_bound, different for different verts");
  else if constexpr (!requirement::has_adj_v2v<M>)
    static_assert(detail::explain_range<vert_t<M>, decltype(adj_v2v), const std::remove_cvref_t<M>&, vert_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_v2v: static ElementRange<vert> adj_v2v(const M&, vert); the verts joined to a vert by an edge");
  else if constexpr (!requirement::has_poly<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::poly: using poly = a std::regular type; names one poly");
  else if constexpr (!requirement::has_polys<M>)
    static_assert(detail::explain_range<poly_t<M>, decltype(polys), const std::remove_cvref_t<M>&>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::polys: static ElementRange<poly> polys(const M&); all polys");
  else if constexpr (!requirement::has_num_polys<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::num_polys: static std::size_t num_polys(const M&); how many polys the walk meets");
  else if constexpr (!requirement::has_poly_index_bound<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::poly_index_bound: static std::size_t poly_index_bound(const M&); exclusive bound of index_of");
  else if constexpr (!requirement::has_poly_index_of<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::index_of: static std::size_t index_of(const M&, poly); below poly_index_bound, different for different polys");
  else if constexpr (!requirement::has_adj_p2p<M>)
    static_assert(detail::explain_range<poly_t<M>, decltype(adj_p2p), const std::remove_cvref_t<M>&, poly_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_p2p: static ElementRange<poly> adj_p2p(const M&, poly); the polys across an edge (surface) or a face (volume)");
  else if constexpr (!requirement::has_edge<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::edge: using edge = a std::regular type; names one edge");
  else if constexpr (!requirement::has_edges<M>)
    static_assert(detail::explain_range<edge_t<M>, decltype(edges), const std::remove_cvref_t<M>&>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::edges: static ElementRange<edge> edges(const M&); all edges");
  else if constexpr (!requirement::has_num_edges<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::num_edges: static std::size_t num_edges(const M&); how many edges the walk meets");
  else if constexpr (!requirement::has_edge_index_bound<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::edge_index_bound: static std::size_t edge_index_bound(const M&); exclusive bound of index_of");
  else if constexpr (!requirement::has_edge_index_of<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::index_of: static std::size_t index_of(const M&, edge); below edge_index_bound, different for different edges");
  else if constexpr (!requirement::has_adj_e2v<M>)
    static_assert(detail::explain_range<vert_t<M>, decltype(adj_e2v), const std::remove_cvref_t<M>&, edge_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_e2v: static ElementRange<vert> adj_e2v(const M&, edge); the two ends of an edge");
  else if constexpr (!requirement::has_adj_e2p<M>)
    static_assert(detail::explain_range<poly_t<M>, decltype(adj_e2p), const std::remove_cvref_t<M>&, edge_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_e2p: static ElementRange<poly> adj_e2p(const M&, edge); the polys at an edge");
  else if constexpr (!requirement::has_adj_v2e<M>)
    static_assert(detail::explain_range<edge_t<M>, decltype(adj_v2e), const std::remove_cvref_t<M>&, vert_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_v2e: static ElementRange<edge> adj_v2e(const M&, vert); the edges at a vert");
  else if constexpr (!requirement::has_adj_v2p<M>)
    static_assert(detail::explain_range<poly_t<M>, decltype(adj_v2p), const std::remove_cvref_t<M>&, vert_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_v2p: static ElementRange<poly> adj_v2p(const M&, vert); the polys at a vert");
  else if constexpr (!requirement::has_adj_p2v<M>)
    static_assert(detail::explain_range<vert_t<M>, decltype(adj_p2v), const std::remove_cvref_t<M>&, poly_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_p2v: static ElementRange<vert> adj_p2v(const M&, poly); the verts of a poly");
  else if constexpr (!requirement::has_adj_p2e<M>)
    static_assert(detail::explain_range<edge_t<M>, decltype(adj_p2e), const std::remove_cvref_t<M>&, poly_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_p2e: static ElementRange<edge> adj_p2e(const M&, poly); the edges of a poly");
  else if constexpr (!requirement::has_face<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::face: using face = a std::regular type; names one face");
  else if constexpr (!requirement::has_distinct_faces<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs face of mesh_traits<M> to be another type than vert, edge and poly; wrap it if it is the same");
  else if constexpr (!requirement::has_faces<M>)
    static_assert(detail::explain_range<face_t<M>, decltype(faces), const std::remove_cvref_t<M>&>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::faces: static ElementRange<face> faces(const M&); all faces");
  else if constexpr (!requirement::has_num_faces<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::num_faces: static std::size_t num_faces(const M&); how many faces the walk meets");
  else if constexpr (!requirement::has_face_index_bound<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::face_index_bound: static std::size_t face_index_bound(const M&); exclusive bound of index_of");
  else if constexpr (!requirement::has_face_index_of<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::index_of: static std::size_t index_of(const M&, face); below face_index_bound, different for different faces");
  else if constexpr (!requirement::has_adj_f2v<M>)
    static_assert(detail::explain_range<vert_t<M>, decltype(adj_f2v), const std::remove_cvref_t<M>&, face_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_f2v: static ElementRange<vert> adj_f2v(const M&, face); the verts of a face in cyclic order");
  else if constexpr (!requirement::has_adj_f2e<M>)
    static_assert(detail::explain_range<edge_t<M>, decltype(adj_f2e), const std::remove_cvref_t<M>&, face_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_f2e: static ElementRange<edge> adj_f2e(const M&, face); the edges of a face");
  else if constexpr (!requirement::has_adj_f2p<M>)
    static_assert(detail::explain_range<poly_t<M>, decltype(adj_f2p), const std::remove_cvref_t<M>&, face_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_f2p: static ElementRange<poly> adj_f2p(const M&, face); the polys on the sides of a face");
  else if constexpr (!requirement::has_adj_v2f<M>)
    static_assert(detail::explain_range<face_t<M>, decltype(adj_v2f), const std::remove_cvref_t<M>&, vert_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_v2f: static ElementRange<face> adj_v2f(const M&, vert); the faces at a vert");
  else if constexpr (!requirement::has_adj_e2f<M>)
    static_assert(detail::explain_range<face_t<M>, decltype(adj_e2f), const std::remove_cvref_t<M>&, edge_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_e2f: static ElementRange<face> adj_e2f(const M&, edge); the faces at an edge");
  else if constexpr (!requirement::has_adj_p2f<M>)
    static_assert(detail::explain_range<face_t<M>, decltype(adj_p2f), const std::remove_cvref_t<M>&, poly_t<M>>() && missing<M>, "concino: VolumeMesh needs mesh_traits<M>::adj_p2f: static ElementRange<face> adj_p2f(const M&, poly); the faces of a poly");
  else if constexpr (!requirement::has_face_is_outward<M>)
    static_assert(missing<M>, "concino: VolumeMesh needs mesh_traits<M>::face_is_outward: static bool face_is_outward(const M&, poly, face); whether the face runs counter-clockwise seen from outside the poly");
  else static_assert(VolumeMesh<M>);
  // clang-format on
}

/// Fails to compile with one sentence that names the first thing M lacks to be a TetMesh and what to write.
template<class M>
consteval void explain_tet_mesh() {
  if constexpr (!VolumeMesh<M>) explain_volume_mesh<M>();
  else if constexpr (!TetMesh<M>)
    static_assert(detail::missing<M>, "concino: TetMesh needs mesh_traits<M>::arity: static constexpr int arity = 4; every poly has 4 verts");
}

/// Fails to compile with one sentence that names the first thing M lacks to be a HexMesh and what to write.
template<class M>
consteval void explain_hex_mesh() {
  if constexpr (!VolumeMesh<M>) explain_volume_mesh<M>();
  else if constexpr (!HexMesh<M>)
    static_assert(detail::missing<M>, "concino: HexMesh needs mesh_traits<M>::arity: static constexpr int arity = 8; every poly has 8 verts");
}

}  // namespace concino

