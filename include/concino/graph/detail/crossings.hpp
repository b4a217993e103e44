// The element that a step of a search crosses: the edge between two verts, or the edge (surface) or face (volume)
// between two polys. It is known if the mesh has these adjacencies; for primal(m) and dual(m), the mesh m is used.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/concepts/views/dual.hpp>
#include <concino/concepts/views/primal.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/graph/detail/graph_of.hpp>

#include <cstddef>

namespace concino::detail {

/// m, or its base mesh if m is primal(...) or dual(...).
template<class M> const M& base_mesh(const M& m) { return m; }
template<class M> decltype(auto) base_mesh(const views::primal_view<M>& m) { return base_mesh(m.base()); }
template<class M> decltype(auto) base_mesh(const views::dual_view<M>& m) { return base_mesh(m.base()); }

template<class M> using base_mesh_t = std::remove_cvref_t<decltype(base_mesh(std::declval<const M&>()))>;

template<class M> concept crosses_edges_between_verts = requirement::has_adj_v2e<M> && requirement::has_adj_e2v<M>;
template<class M> concept crosses_facets_between_polys = requires(const M& m, poly_t<M> p, facet_t<M> x) {
  adj_p2facet(m, p), adj_facet2p(m, x);
};

/// `type`: what is crossed between two nodes, void if the mesh has no access to it.
template<class G> struct crossing { using type = void; };
template<class M>
  requires crosses_edges_between_verts<base_mesh_t<M>>
struct crossing<primal_graph<M>> { using type = edge_t<base_mesh_t<M>>; };
template<class M>
  requires crosses_facets_between_polys<base_mesh_t<M>>
struct crossing<dual_graph<M>> { using type = facet_t<base_mesh_t<M>>; };

template<class G> using crossed_t = typename crossing<G>::type;
template<class M, class S> using crossed_of = crossed_t<graph_of<M, S>>;

/// The type of may_cross for graphs without crossings: it accepts no predicate, and its message says why.
struct nothing_to_cross {
  constexpr nothing_to_cross() = default;
  constexpr nothing_to_cross(std::nullptr_t) {}
  template<class F, class R = mistake::remedy<"may_cross needs the edges or faces between neighbours: adj_v2e and adj_e2v between verts; adj_p2e and adj_e2p between polys of a surface, adj_p2f and adj_f2p of a volume. This type is only a graph; use may_enter to exclude nodes">>
  nothing_to_cross(const F&) = delete;  // may_cross needs the edges or faces between neighbours: adj_v2e and adj_e2v ...; use may_enter to exclude nodes
  constexpr explicit operator bool() const { return false; }
};
template<class C> struct crossing_test { using type = function_ref<bool(C)>; };
template<> struct crossing_test<void> { using type = nothing_to_cross; };
template<class C> using may_cross_t = typename crossing_test<C>::type;

/// Calls visit(w, x) for each neighbour w of v and each edge or face x between them, so several times if they share
/// several.
template<class M, class F>
  requires(!std::is_void_v<crossed_t<primal_graph<M>>>)
void for_each_crossing(const primal_graph<M>& g, const vert_t<M>& v, const F& visit) {
  const auto& m = base_mesh(g.m);
  for (const auto e : adj_v2e(m, v))
    for (const vert_t<M> w : adj_e2v(m, e))
      if (!(w == v)) visit(w, e);
}

template<class M, class F>
  requires(!std::is_void_v<crossed_t<dual_graph<M>>>)
void for_each_crossing(const dual_graph<M>& g, const poly_t<M>& p, const F& visit) {
  const auto& m = base_mesh(g.m);
  for (const auto x : adj_p2facet(m, p))
    for (const poly_t<M> q : other_polys(m, p, x)) visit(q, x);
}

/// Calls visit(w, x) for those of these for which may_cross and may_enter (either may be empty) are true.
template<class G, class F>
void for_each_open_crossing(const G& g, const typename G::node& v, function_ref<bool(typename G::node)> may_enter,
                          const function_ref<bool(crossed_t<G>)>& may_cross, const F& visit) {
  for_each_crossing(g, v, [&](const typename G::node& w, const crossed_t<G>& x) {
    if ((!may_cross || may_cross(x)) && (!may_enter || may_enter(w))) visit(w, x);
  });
}

/// Calls visit(w) for the neighbours of v for which may_cross and may_enter (either may be empty) are true; with
/// may_cross, possibly more than once.
template<class G, class F>
void for_each_open_neighbour(const G& g, const typename G::node& v, function_ref<bool(typename G::node)> may_enter,
                   [[maybe_unused]] const may_cross_t<crossed_t<G>>& may_cross, const F& visit) {
  if constexpr (!std::is_void_v<crossed_t<G>>) {
    if (may_cross) {
      // without for_each_open_crossing, which would slow down the loop below
      for_each_crossing(g, v, [&](const typename G::node& w, const auto& x) {
        if (may_cross(x) && (!may_enter || may_enter(w))) visit(w);
      });
      return;
    }
  }
  for (const typename G::node w : g.neighbours(v))
    if (!may_enter || may_enter(w)) visit(w);
}

/// The same with may_enter and may_cross of a search's options: calls visit(w, put_crossed). put_crossed() stores what
/// lies between v and w in the map options.crossed, if there is one.
template<class G, class Options, class F>
void for_each_recorded_neighbour(const G& g, const typename G::node& v, const Options& options, const F& visit) {
  if constexpr (!std::is_void_v<crossed_t<G>>) {
    if (options.crossed) {
      for_each_open_crossing(
          g, v, options.may_enter, options.may_cross,
          [&](const typename G::node& w, const crossed_t<G>& x) { visit(w, [&] { options.crossed.put(w, x); }); });
      return;
    }
  }
  for_each_open_neighbour(g, v, options.may_enter, options.may_cross,
                          [&](const typename G::node& w) { visit(w, [] {}); });
}

}  // namespace concino::detail
