// One graph interface for algorithms on verts and on polys: nodes, neighbours and index. The type of the node selects
// the graph.
#pragma once

#include <concino/concepts/dual_graph.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/concepts/primal_graph.hpp>
#include <concino/concepts/views/dual.hpp>
#include <concino/core/error.hpp>
#include <concino/core/iterable.hpp>
#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/mesh/element_map.hpp>

#include <initializer_list>
#include <string>
#include <type_traits>

namespace concino::detail {

/// The graph of verts, joined by edges.
template<PrimalGraph M>
struct primal_graph {
  using mesh = M;
  using node = vert_t<M>;
  static constexpr const char* element_name = "vert";
  const M& m;

  std::size_t num_nodes() const { return num_verts(m); }
  std::size_t bound() const { return vert_index_bound(m); }
  std::size_t index(const node& v) const { return index_of(m, v); }
  decltype(auto) nodes() const { return verts(m); }
  decltype(auto) neighbours(const node& v) const { return adj_v2v(m, v); }
};

/// The graph of polys, joined by shared edges (surfaces) or faces (volumes).
template<DualGraph M>
struct dual_graph {
  using mesh = M;
  using node = poly_t<M>;
  static constexpr const char* element_name = "poly";
  const M& m;

  std::size_t num_nodes() const { return num_polys(m); }
  std::size_t bound() const { return poly_index_bound(m); }
  std::size_t index(const node& p) const { return index_of(m, p); }
  decltype(auto) nodes() const { return polys(m); }
  decltype(auto) neighbours(const node& p) const { return adj_p2p(m, p); }
};

// Selects the graph for a type X: the one whose nodes have exactly that type, else the only one to whose nodes X
// converts (handles of a library often have a plain and a smart variant).
template<class M, class X> concept is_vert_type = PrimalGraph<M> && std::same_as<X, vert_t<M>>;
template<class M, class X> concept names_poly = DualGraph<M> && std::same_as<X, poly_t<M>>;
template<class M, class X> concept converts_to_vert = PrimalGraph<M> && std::convertible_to<X, vert_t<M>>;
template<class M, class X> concept converts_to_poly = DualGraph<M> && std::convertible_to<X, poly_t<M>>;

/// No graph: used in the options of a function if the graph is unknown, so that the constraints of the function are
/// checked and explain the error.
struct no_graph {
  using mesh = void;
  struct node {};
};
template<class M, class X> struct graph_for { using type = no_graph; };
template<class M, class X>
  requires is_vert_type<M, X> || (converts_to_vert<M, X> && !names_poly<M, X> && !converts_to_poly<M, X>)
struct graph_for<M, X> { using type = primal_graph<std::remove_cvref_t<M>>; };
template<class M, class X>
  requires names_poly<M, X> || (converts_to_poly<M, X> && !is_vert_type<M, X> && !converts_to_vert<M, X>)
struct graph_for<M, X> { using type = dual_graph<std::remove_cvref_t<M>>; };

/// The type of node in a source: the source itself if it is a node (which may be an array of coordinates), its value
/// type if it is a container of nodes.
template<class M, class S> struct element_of_source { using type = S; };
template<class M, core::iterable S>
  requires(!is_vert_type<M, S> && !names_poly<M, S>)
struct element_of_source<M, S> { using type = std::remove_cvref_t<decltype(*std::declval<const S&>().begin())>; };
template<class M, class S> using source_element = typename element_of_source<std::remove_cvref_t<M>, S>::type;

template<class M, class S> using graph_of = typename graph_for<std::remove_cvref_t<M>, source_element<M, S>>::type;
template<class M, class S> using node_of = typename graph_of<M, S>::node;

template<class T, class G>
auto make_node_map(const G& g, const T& init) {
  return element_map<typename G::mesh, typename G::node, T>(g.m, g.bound(), init);
}

template<class G>
std::string name_of(const G& g, const typename G::node& x) {
  return core::joined({G::element_name, " ", core::number_text(g.index(x))});
}

template<class G>
void expect_node(const G& g, const typename G::node& x, const char* caller, const char* role) {
  if (contains(g.m, x)) return;
  core::throw_joined<invalid_mesh>(
      {caller, ": the ", role, " is not a ", G::element_name, " of the mesh; take one from ", G::element_name, "s(m)"});
}

/// The graph of algorithms without a source: that of the verts, or of the polys if the argument is dual(m).
template<class M> struct graph_by_default { using type = no_graph; };
template<PrimalGraph M> struct graph_by_default<M> { using type = primal_graph<M>; };
template<DualGraph M> struct graph_by_default<views::dual_view<M>> { using type = dual_graph<views::dual_view<M>>; };
template<class M> using default_graph_of = typename graph_by_default<std::remove_cvref_t<M>>::type;
template<class M> using default_node_of = typename default_graph_of<M>::node;

[[noreturn, gnu::noinline, gnu::cold]] inline void throw_empty_list(const char* caller, const char* role,
                                                                    const char* word) {
  core::throw_joined<invalid_argument>({caller, ": there is no ", role, "; give at least one ", word});
}

/// Calls visit(node) for the one source or each of several, after checking that the mesh contains it.
/// Errors: invalid_argument if there is none.
template<class G, class S, class F>
void for_each_source(const G& g, const S& source, const char* caller, F&& visit, const char* role = "source") {
  const auto take = [&](const typename G::node& x) {
    expect_node(g, x, caller, role);
    visit(x);
  };
  if constexpr (core::iterable<S> && !std::same_as<S, typename G::node>) {
    bool any = false;
    for (const auto& x : source) {
      take(static_cast<typename G::node>(x));
      any = true;
    }
    if (!any) throw_empty_list(caller, role, G::element_name);
  } else {
    take(static_cast<typename G::node>(source));
  }
}

}  // namespace concino::detail

namespace concino::requirement {

template<class M> inline constexpr bool is_dual_view_v = false;
template<class M> inline constexpr bool is_dual_view_v<views::dual_view<M>> = true;
template<class M> concept is_dual_view = is_dual_view_v<std::remove_cvref_t<M>>;
// of the polys of m write connected_components(dual(m)), spanning_tree(dual(m))
template<class M> concept is_graph = PrimalGraph<M> || is_dual_view<M>;

/// X is a type for polys rather than verts of M, whether or not M has them.
template<class M, class X> concept converts_to_vert_type = std::convertible_to<X, vert_t<M>>;
template<class M, class X>
concept is_poly_type = std::same_as<X, poly_t<M>> ||(std::convertible_to<X, poly_t<M>> && !converts_to_vert_type<M, X>);
template<class M, class X> concept is_no_poly_type = !is_poly_type<M, X>;
template<class M, class S>
concept is_vert_or_poly = !std::same_as<concino::detail::graph_of<M, S>, concino::detail::no_graph>;

/// S is a vert or a poly of M, or a container of either, and M has that graph. Written so that compilers report what
/// that graph lacks.
template<class M, class S>
concept is_source = (PrimalGraph<M> || is_poly_type<M, concino::detail::source_element<M, S>>)&&(
    DualGraph<M> || is_no_poly_type<M, concino::detail::source_element<M, S>>)&&is_vert_or_poly<M, S>;

}  // namespace concino::requirement
