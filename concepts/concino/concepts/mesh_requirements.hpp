// The requirements that surfaces and volumes have in common: a dimension, edges and adjacencies.
#pragma once

#include <concino/concepts/dual_graph.hpp>
#include <concino/concepts/primal_graph.hpp>

namespace concino::requirement {

template<class M> concept is_surface = dimension_v<M> == 2;
struct surface_dimension_requirement {
  template<class M> static constexpr bool holds = is_surface<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_constant<requires { traits<M>::dimension; }, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs dimension: static constexpr int dimension = 2; of a surface");
  }
};

template<class M> concept is_volume = dimension_v<M> == 3;
struct volume_dimension_requirement {
  template<class M> static constexpr bool holds = is_volume<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_constant<requires { traits<M>::dimension; }, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs dimension: static constexpr int dimension = 3; of a volume");
  }
};

// Explained before missing types, since equal types change the overloads of the other members. It holds if a type is
// missing.
template<class M>
concept has_distinct_descriptors =
    !requires { requires std::same_as<vert_t<M>, edge_t<M>>; } &&
    !requires { requires std::same_as<vert_t<M>, poly_t<M>>; } &&
    !requires { requires std::same_as<edge_t<M>, poly_t<M>>; };
struct distinct_descriptors_requirement {
  template<class M> static constexpr bool holds = has_distinct_descriptors<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::missing<M>, "concino: vert, edge and poly of mesh_traits<M> have to be different types: overloads choose the graph of the verts or of the polys by them; wrap those that are the same");
  }
};

template<class M> concept has_edge = requires { typename edge_t<M>; } && std::regular<edge_t<M>>;
struct edge_requirement {
  template<class M> static constexpr bool holds = has_edge<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_regular<edge_t, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs edge: using edge = a std::regular type; names one edge");
  }
};

template<class M> concept has_edges = requires(const std::remove_cvref_t<M>& m) {
  { traits<M>::edges(m) } -> ElementRange<edge_t<M>>;
};
struct edges_requirement {
  template<class M> static constexpr bool holds = has_edges<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::edges; }, edge_t<M>, edges_verb, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs edges: static ElementRange<edge> edges(const M&); all edges");
  }
};

template<class M> concept has_num_edges = requires(const std::remove_cvref_t<M>& m) {
  { traits<M>::num_edges(m) } -> std::convertible_to<std::size_t>;
};
struct num_edges_requirement {
  template<class M> static constexpr bool holds = has_num_edges<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<requires { &traits<M>::num_edges; }, num_edges_verb, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs num_edges: static std::size_t num_edges(const M&); the number of edges in edges(m)");
  }
};

template<class M> concept has_edge_index_bound = requires(const std::remove_cvref_t<M>& m) {
  { traits<M>::edge_index_bound(m) } -> std::convertible_to<std::size_t>;
};
struct edge_index_bound_requirement {
  template<class M> static constexpr bool holds = has_edge_index_bound<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<requires { &traits<M>::edge_index_bound; }, edge_index_bound_verb, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs edge_index_bound: static std::size_t edge_index_bound(const M&); exclusive bound of index_of");
  }
};

template<class M> concept has_edge_index_of = requires(const std::remove_cvref_t<M>& m, edge_t<M> e) {
  { traits<M>::index_of(m, e) } -> std::convertible_to<std::size_t>;
};
struct edge_index_of_requirement {
  template<class M> static constexpr bool holds = has_edge_index_of<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<false, index_of_verb, M, edge_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs index_of: static std::size_t index_of(const M&, edge); below edge_index_bound, different for different edges");
  }
};

template<class M> concept has_adj_e2v = requires(const std::remove_cvref_t<M>& m, edge_t<M> e) {
  { traits<M>::adj_e2v(m, e) } -> ElementRange<vert_t<M>>;
};
struct adj_e2v_requirement {
  template<class M> static constexpr bool holds = has_adj_e2v<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_e2v; }, vert_t<M>, adj_e2v_verb, M, edge_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_e2v: static ElementRange<vert> adj_e2v(const M&, edge); the two ends of an edge");
  }
};

template<class M> concept has_adj_e2p = requires(const std::remove_cvref_t<M>& m, edge_t<M> e) {
  { traits<M>::adj_e2p(m, e) } -> ElementRange<poly_t<M>>;
};
struct adj_e2p_requirement {
  template<class M> static constexpr bool holds = has_adj_e2p<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_e2p; }, poly_t<M>, adj_e2p_verb, M, edge_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_e2p: static ElementRange<poly> adj_e2p(const M&, edge); the polys at an edge");
  }
};

template<class M> concept has_adj_v2e = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) {
  { traits<M>::adj_v2e(m, v) } -> ElementRange<edge_t<M>>;
};
struct adj_v2e_requirement {
  template<class M> static constexpr bool holds = has_adj_v2e<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_v2e; }, edge_t<M>, adj_v2e_verb, M, vert_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_v2e: static ElementRange<edge> adj_v2e(const M&, vert); the edges at a vert");
  }
};

template<class M> concept has_adj_v2p = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) {
  { traits<M>::adj_v2p(m, v) } -> ElementRange<poly_t<M>>;
};
struct adj_v2p_requirement {
  template<class M> static constexpr bool holds = has_adj_v2p<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_v2p; }, poly_t<M>, adj_v2p_verb, M, vert_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_v2p: static ElementRange<poly> adj_v2p(const M&, vert); the polys at a vert");
  }
};

template<class M> concept has_adj_p2v = requires(const std::remove_cvref_t<M>& m, poly_t<M> p) {
  { traits<M>::adj_p2v(m, p) } -> ElementRange<vert_t<M>>;
};
struct adj_p2v_requirement {
  template<class M> static constexpr bool holds = has_adj_p2v<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_p2v; }, vert_t<M>, adj_p2v_verb, M, poly_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_p2v: static ElementRange<vert> adj_p2v(const M&, poly); the verts of a poly; on a surface in cyclic order, of tets and hexes in the standard order");
  }
};

template<class M> concept has_adj_p2e = requires(const std::remove_cvref_t<M>& m, poly_t<M> p) {
  { traits<M>::adj_p2e(m, p) } -> ElementRange<edge_t<M>>;
};
struct adj_p2e_requirement {
  template<class M> static constexpr bool holds = has_adj_p2e<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_p2e; }, edge_t<M>, adj_p2e_verb, M, poly_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_p2e: static ElementRange<edge> adj_p2e(const M&, poly); the edges of a poly");
  }
};

template<class M> concept has_arity_3 = arity_v<M> == 3;
struct arity_3_requirement {
  template<class M> static constexpr bool holds = has_arity_3<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_constant<requires { traits<M>::arity; }, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs arity: static constexpr int arity = 3; every poly has 3 verts");
  }
};

template<class M> concept has_arity_4 = arity_v<M> == 4;
struct arity_4_requirement {
  template<class M> static constexpr bool holds = has_arity_4<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_constant<requires { traits<M>::arity; }, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs arity: static constexpr int arity = 4; every poly has 4 verts");
  }
};

template<class M> concept has_arity_8 = arity_v<M> == 8;
struct arity_8_requirement {
  template<class M> static constexpr bool holds = has_arity_8<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_constant<requires { traits<M>::arity; }, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs arity: static constexpr int arity = 8; every poly has 8 verts");
  }
};

/// The requirements common to surfaces and volumes, except dimension and distinct descriptors.
using mesh_requirements =
    list<primal_graph_requirements, dual_graph_requirements, edge_requirement, edges_requirement, num_edges_requirement,
         edge_index_bound_requirement, edge_index_of_requirement, adj_e2v_requirement, adj_e2p_requirement,
         adj_v2e_requirement, adj_v2p_requirement, adj_p2v_requirement, adj_p2e_requirement>;

}  // namespace concino::requirement

// For users who include only a part: explain_surface_mesh<M>() and explain_volume_mesh<M>() say what is missing.
#include <concino/concepts/surface_mesh.hpp>
#include <concino/concepts/volume_mesh.hpp>
