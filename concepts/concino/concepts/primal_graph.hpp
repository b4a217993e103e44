// PrimalGraph: verts as nodes, joined by edges. The concept for shortest paths, searches and all other algorithms that
// need no polys.
//
// Laws (the compiler cannot check them; check_laws of <concino/validate.hpp> does):
//   PG1  index_of is below vert_index_bound and differs between verts
//   PG2  iterating over verts(m) yields num_verts(m) verts, each once, and the same ones on every pass; `contains`, if
//        defined, agrees
//   PG3  w is in adj_v2v(v) exactly if v is in adj_v2v(w)
//   PG4  adj_v2v(v) contains neither v itself nor any vert twice, and only verts of m
#pragma once

#include <concino/concepts/mesh_traits.hpp>

namespace concino {

namespace requirement {

template<class M> concept has_vert = requires { typename vert_t<M>; } && std::regular<vert_t<M>>;
struct vert_requirement {
  template<class M> static constexpr bool holds = has_vert<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_regular<vert_t, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs vert: using vert = a std::regular type; names one vert");
  }
};

template<class M> concept has_verts = requires(const std::remove_cvref_t<M>& m) {
  { traits<M>::verts(m) } -> ElementRange<vert_t<M>>;
};
struct verts_requirement {
  template<class M> static constexpr bool holds = has_verts<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::verts; }, vert_t<M>, verts_verb, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs verts: static ElementRange<vert> verts(const M&); all verts");
  }
};

template<class M> concept has_num_verts = requires(const std::remove_cvref_t<M>& m) {
  { traits<M>::num_verts(m) } -> std::convertible_to<std::size_t>;
};
struct num_verts_requirement {
  template<class M> static constexpr bool holds = has_num_verts<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<requires { &traits<M>::num_verts; }, num_verts_verb, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs num_verts: static std::size_t num_verts(const M&); the number of verts in verts(m)");
  }
};

template<class M> concept has_vert_index_bound = requires(const std::remove_cvref_t<M>& m) {
  { traits<M>::vert_index_bound(m) } -> std::convertible_to<std::size_t>;
};
struct vert_index_bound_requirement {
  template<class M> static constexpr bool holds = has_vert_index_bound<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<requires { &traits<M>::vert_index_bound; }, vert_index_bound_verb, M>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs vert_index_bound: static std::size_t vert_index_bound(const M&); exclusive bound of index_of");
  }
};

template<class M> concept has_vert_index_of = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) {
  { traits<M>::index_of(m, v) } -> std::convertible_to<std::size_t>;
};
struct vert_index_of_requirement {
  template<class M> static constexpr bool holds = has_vert_index_of<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_value<false, index_of_verb, M, vert_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs index_of: static std::size_t index_of(const M&, vert); below vert_index_bound, different for different verts");
  }
};

template<class M> concept has_adj_v2v = requires(const std::remove_cvref_t<M>& m, vert_t<M> v) {
  { traits<M>::adj_v2v(m, v) } -> ElementRange<vert_t<M>>;
};
struct adj_v2v_requirement {
  template<class M> static constexpr bool holds = has_adj_v2v<M>;
  template<class M> static consteval void explain() {
    static_assert(detail::explain_range<requires { &traits<M>::adj_v2v; }, vert_t<M>, adj_v2v_verb, M, vert_t<M>>());
    static_assert(detail::missing<M>, "concino: mesh_traits<M> needs adj_v2v: static ElementRange<vert> adj_v2v(const M&, vert); the verts joined to a vert by an edge");
  }
};

using primal_graph_requirements = list<traits_requirements, vert_requirement, verts_requirement, num_verts_requirement,
                                       vert_index_bound_requirement, vert_index_of_requirement, adj_v2v_requirement>;

}  // namespace requirement

template<class M>
concept PrimalGraph = requirement::is_adapted<M> && requirement::has_vert<M> && requirement::has_verts<M> &&
    requirement::has_num_verts<M> && requirement::has_vert_index_bound<M> && requirement::has_vert_index_of<M> &&
    requirement::has_adj_v2v<M>;

/// Fails to compile with one sentence that names the first thing M lacks to be a PrimalGraph and what to write.
template<class M>
consteval void explain_primal_graph() {
  if constexpr (!PrimalGraph<M>)
    requirement::first_missing<requirement::primal_graph_requirements, M>::template explain<M>();
}

}  // namespace concino
