// VolumeMesh: verts, edges, faces and polyhedra with the adjacencies between them.
//
// Laws, in addition to those of both graphs and SM1, SM2 (edges are as in a surface):
//   VM1  index_of of faces is below face_index_bound and differs; iterating over faces(m) yields num_faces(m), each
//        once
//   VM2  adj_f2v(f) is the face in cyclic order: two consecutive verts are the ends of one of adj_f2e(f); no vert
//        twice, as many edges as verts
//   VM3  adj_e2f mirrors adj_f2e, adj_v2f mirrors adj_f2v, adj_f2p mirrors adj_p2f, nothing twice
//   VM4  adj_p2v(p) and adj_p2e(p) are the verts and edges of p's faces, adj_v2p and adj_e2p mirror them, nothing twice
//   VM5  adj_p2p(p) is the polys that share a face with p
//   VM6  if each edge of a poly is in two of its faces, the poly is oriented consistently: of the two faces, oriented
//        outward, one has the direction of the edge and the other the opposite one
//   VM7  if the type fixes that polys are tets or hexes, adj_p2v lists 4 or 8 verts in the standard order: the tet's
//        faces are 0 2 1, 0 1 3, 0 3 2, 1 2 3, the hex's 0 3 2 1, 1 2 6 5, 4 5 6 7, 3 0 4 7, 0 1 5 4, 2 3 7 6, in any
//        order
//   VM8  the k-th edge of adj_f2e(f) joins the k-th vert of adj_f2v(f) and the next one; the last edge joins the last
//        vert and the first. If the type fixes that polys are tets, the edges of adj_p2e(p) join the verts 01 02 03 12
//        13 23 of adj_p2v(p)
//
// A model whose lists have another order declares static constexpr bool edges_in_order = false; in its traits, and the
// verbs sort.
#pragma once

#include <concino/concepts/mesh_requirements.hpp>

namespace concino {

namespace requirement {

// As for the other types: it holds if a type is missing.
template<class M>
concept has_distinct_faces =
    !requires { requires std::same_as<vert_t<M>, face_t<M>>; } &&
    !requires { requires std::same_as<edge_t<M>, face_t<M>>; } &&
    !requires { requires std::same_as<poly_t<M>, face_t<M>>; };
struct distinct_faces_requirement {
  template<class M> static constexpr bool holds = has_distinct_faces<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::missing<M>, "concino: face of mesh_traits<M> has to be another type than vert, edge and poly; wrap it if it is the same");
  }
};

template<class M> concept has_face = requires { typename face_t<M>; } && std::regular<face_t<M>>;
struct face_requirement {
  template<class M> static constexpr bool holds = has_face<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_regular<face_t, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs face: using face = a std::regular type; names one face");
  }
};

template<class M> concept has_faces = requires(const std::remove_cvref_t<M>& m) {
  { traits<M>::faces(m) } -> ElementRange<face_t<M>>;
};
struct faces_requirement {
  template<class M> static constexpr bool holds = has_faces<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::faces; }, face_t<M>, faces_verb, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs faces: static ElementRange<face> faces(const M&); all faces");
  }
};

template<class M> concept has_num_faces = requires(const std::remove_cvref_t<M>& m) {
  { traits<M>::num_faces(m) } -> std::convertible_to<std::size_t>;
};
struct num_faces_requirement {
  template<class M> static constexpr bool holds = has_num_faces<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<requires { &traits<M>::num_faces; }, num_faces_verb, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs num_faces: static std::size_t num_faces(const M&); the number of faces in faces(m)");
  }
};

template<class M> concept has_face_index_bound = requires(const std::remove_cvref_t<M>& m) {
  { traits<M>::face_index_bound(m) } -> std::convertible_to<std::size_t>;
};
struct face_index_bound_requirement {
  template<class M> static constexpr bool holds = has_face_index_bound<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<requires { &traits<M>::face_index_bound; }, face_index_bound_verb, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs face_index_bound: static std::size_t face_index_bound(const M&); exclusive bound of index_of");
  }
};

template<class M> concept has_face_index_of = requires(const std::remove_cvref_t<M>& m, face_t<M> f) {
  { traits<M>::index_of(m, f) } -> std::convertible_to<std::size_t>;
};
struct face_index_of_requirement {
  template<class M> static constexpr bool holds = has_face_index_of<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<false, index_of_verb, M, face_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs index_of: static std::size_t index_of(const M&, face); below face_index_bound, different for different faces");
  }
};

template<class M> concept has_adj_f2v = requires(const std::remove_cvref_t<M>& m, face_t<M> f) {
  { traits<M>::adj_f2v(m, f) } -> ElementRange<vert_t<M>>;
};
struct adj_f2v_requirement {
  template<class M> static constexpr bool holds = has_adj_f2v<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_f2v; }, vert_t<M>, adj_f2v_verb, M, face_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_f2v: static ElementRange<vert> adj_f2v(const M&, face); the verts of a face in cyclic order");
  }
};

template<class M> concept has_adj_f2e = requires(const std::remove_cvref_t<M>& m, face_t<M> f) {
  { traits<M>::adj_f2e(m, f) } -> ElementRange<edge_t<M>>;
};
struct adj_f2e_requirement {
  template<class M> static constexpr bool holds = has_adj_f2e<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_f2e; }, edge_t<M>, adj_f2e_verb, M, face_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_f2e: static ElementRange<edge> adj_f2e(const M&, face); the edges of a face");
  }
};

template<class M> concept has_adj_f2p = requires(const std::remove_cvref_t<M>& m, face_t<M> f) {
  { traits<M>::adj_f2p(m, f) } -> ElementRange<poly_t<M>>;
};
struct adj_f2p_requirement {
  template<class M> static constexpr bool holds = has_adj_f2p<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_f2p; }, poly_t<M>, adj_f2p_verb, M, face_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_f2p: static ElementRange<poly> adj_f2p(const M&, face); the polys of a face");
  }
};

template<class M> concept has_adj_v2f = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) {
  { traits<M>::adj_v2f(m, v) } -> ElementRange<face_t<M>>;
};
struct adj_v2f_requirement {
  template<class M> static constexpr bool holds = has_adj_v2f<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_v2f; }, face_t<M>, adj_v2f_verb, M, vert_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_v2f: static ElementRange<face> adj_v2f(const M&, vert); the faces at a vert");
  }
};

template<class M> concept has_adj_e2f = requires(const std::remove_cvref_t<M>& m, edge_t<M> e) {
  { traits<M>::adj_e2f(m, e) } -> ElementRange<face_t<M>>;
};
struct adj_e2f_requirement {
  template<class M> static constexpr bool holds = has_adj_e2f<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_e2f; }, face_t<M>, adj_e2f_verb, M, edge_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_e2f: static ElementRange<face> adj_e2f(const M&, edge); the faces at an edge");
  }
};

template<class M> concept has_adj_p2f = requires(const std::remove_cvref_t<M>& m, poly_t<M> p) {
  { traits<M>::adj_p2f(m, p) } -> ElementRange<face_t<M>>;
};
struct adj_p2f_requirement {
  template<class M> static constexpr bool holds = has_adj_p2f<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_p2f; }, face_t<M>, adj_p2f_verb, M, poly_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_p2f: static ElementRange<face> adj_p2f(const M&, poly); the faces of a poly");
  }
};

template<class M> concept has_face_is_outward = requires(const std::remove_cvref_t<M>& m, poly_t<M> p, face_t<M> f) {
  { traits<M>::face_is_outward(m, p, f) } -> std::convertible_to<bool>;
};
struct face_is_outward_requirement {
  template<class M> static constexpr bool holds = has_face_is_outward<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<requires { &traits<M>::face_is_outward; }, face_is_outward_verb, M, poly_t<M>,
                                        face_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs face_is_outward: static bool face_is_outward(const M&, poly, face); whether the face runs counter-clockwise seen from outside the poly");
  }
};

using volume_mesh_requirements =
    list<traits_requirements, volume_dimension_requirement, distinct_descriptors_requirement,
         distinct_faces_requirement, mesh_requirements, face_requirement, faces_requirement, num_faces_requirement,
         face_index_bound_requirement, face_index_of_requirement, adj_f2v_requirement, adj_f2e_requirement,
         adj_f2p_requirement, adj_v2f_requirement, adj_e2f_requirement, adj_p2f_requirement,
         face_is_outward_requirement>;
using tet_mesh_requirements = list<volume_mesh_requirements, arity_4_requirement>;
using hex_mesh_requirements = list<volume_mesh_requirements, arity_8_requirement>;

}  // namespace requirement

template<class M>
concept VolumeMesh = PrimalGraph<M> && DualGraph<M> && requirement::is_volume<M> && requirement::has_edge<M> &&
    requirement::has_distinct_descriptors<M> && requirement::has_face<M> && requirement::has_distinct_faces<M> &&
    requirement::has_edges<M> && requirement::has_num_edges<M> && requirement::has_edge_index_bound<M> &&
    requirement::has_edge_index_of<M> && requirement::has_faces<M> && requirement::has_num_faces<M> &&
    requirement::has_face_index_bound<M> && requirement::has_face_index_of<M> && requirement::has_adj_e2v<M> &&
    requirement::has_adj_e2p<M> && requirement::has_adj_v2e<M> && requirement::has_adj_v2p<M> &&
    requirement::has_adj_p2v<M> && requirement::has_adj_p2e<M> && requirement::has_adj_f2v<M> &&
    requirement::has_adj_f2e<M> && requirement::has_adj_f2p<M> && requirement::has_adj_v2f<M> &&
    requirement::has_adj_e2f<M> && requirement::has_adj_p2f<M> && requirement::has_face_is_outward<M>;

/// Volumes of tetrahedra, of hexahedra, if the type fixes that at compile time.
template<class M> concept TetMesh = VolumeMesh<M> && requirement::has_arity_4<M>;
template<class M> concept HexMesh = VolumeMesh<M> && requirement::has_arity_8<M>;

/// Fails to compile with one sentence that names the first thing M lacks to be a VolumeMesh and what to write.
template<class M>
consteval void explain_volume_mesh() {
  if constexpr (!VolumeMesh<M>)
    requirement::first_missing<requirement::volume_mesh_requirements, M>::template explain<M>();
}

/// Fails to compile with one sentence that names the first thing M lacks to be a TetMesh and what to write.
template<class M>
consteval void explain_tet_mesh() {
  if constexpr (!TetMesh<M>) requirement::first_missing<requirement::tet_mesh_requirements, M>::template explain<M>();
}

/// Fails to compile with one sentence that names the first thing M lacks to be a HexMesh and what to write.
template<class M>
consteval void explain_hex_mesh() {
  if constexpr (!HexMesh<M>) requirement::first_missing<requirement::hex_mesh_requirements, M>::template explain<M>();
}

}  // namespace concino
