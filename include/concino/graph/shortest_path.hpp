// The shortest path from one element to another, or between two sets of elements.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/graph/dijkstra.hpp>

#include <limits>
#include <vector>

namespace concino {

/// Node is a vert (primal graph) or a poly (dual graph). Crossed is what lies between two of them, void if the mesh has
/// no access to it.
template<class Node, class Crossed = void>
struct shortest_path_options {
  function_ref<bool(Node)> may_enter = nullptr;       // false: the path may not enter this node (empty: it may enter
                                                      // all). Sources are exempt.
  detail::may_cross_t<Crossed> may_cross = nullptr;   // false: the path may not cross this edge or face (empty: it may
                                                      // cross all)
  double max_distance = std::numeric_limits<double>::infinity();  // >= 0, in units of length; longer paths do not count
};

namespace requirement {

/// T is a node, or a container of nodes, of the graph selected by S.
template<class M, class S, class T>
concept is_target =
    is_source<M, S> && is_source<M, T> && std::same_as<concino::detail::node_of<M, S>, concino::detail::node_of<M, T>>;

}  // namespace requirement

namespace detail {

template<class G, class S, class T, class L>
auto shortest_path(const G& g, const S& source, const T& target, const L& lengths,
                   const shortest_path_options<typename G::node, crossed_t<G>>& options) {
  using node = typename G::node;
  std::vector<node> path, targets;
  for_each_source(g, target, "shortest_path", [&](const node& t) { targets.push_back(t); }, "target");
  auto from = make_node_map<node>(g, node{});
  const auto distance = dijkstra(g, source, lengths,
                                 {.targets = targets,
                                  .nearest_target = true,
                                  .may_enter = options.may_enter,
                                  .may_cross = options.may_cross,
                                  .predecessors = &from,
                                  .max_distance = options.max_distance},
                                 "shortest_path");
  const node* nearest = nullptr;
  for (const node& t : targets)
    if (distance[t] < (nearest ? distance[*nearest] : std::numeric_limits<double>::infinity())) nearest = &t;
  if (nearest) path = path_to(from, *nearest);
  return path;
}

}  // namespace detail

/// The shortest path between two verts along edges, or between two polys from poly to poly. Source and target may each
/// be a container or braces of several: the path then joins the nearest pair. Without a length function, an arc has the
/// Euclidean length between the verts, or between the means of the verts of the polys.
/// Needs:  PrimalGraph M for verts, DualGraph M for polys; length(from, to) >= 0. Without a length: Embedded, and
///         AnyMesh for polys. may_cross needs the edges or faces of an AnyMesh.
/// Result: the verts or polys of the path from source to target, both included: one if they are the same, none if there
///         is no path. Of targets equally near the first is taken; of equally short paths, the one in dijkstra's
///         predecessors, which is the same in every run.
/// Cost:   O(E log V) time, O(V) memory; the search stops at the nearest target.
/// Errors: invalid_mesh if a source or target is not an element of m, or if a length that the search reads is negative
///         or not a number. invalid_argument if there is no source or no target, or max_distance is negative or not a
///         number.
/// Source: Dijkstra 1959; paper section 2.2, "Distances and paths".
template<class M, class S, class T = std::initializer_list<detail::node_of<M, S>>>
  requires requirement::is_target<M, S, T> && requirement::has_lengths<M, S>
auto shortest_path(const M& m, const S& source, const T& target,  // may_cross: not of a bare graph
                   const shortest_path_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  const detail::graph_of<M, S> g{m};
  return detail::shortest_path(g, source, target, detail::default_lengths(g), options);
}

template<class M, class S, class L, class T = std::initializer_list<detail::node_of<M, S>>>
  requires requirement::is_target<M, S, T> && requirement::is_length<L, detail::node_of<M, S>>
auto shortest_path(const M& m, const S& source, const T& target, const L& length,  // may_cross: not of a bare graph
                   const shortest_path_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  return detail::shortest_path(detail::graph_of<M, S>{m}, source, target, detail::input_lengths<L>{length}, options);
}

template<class M, class S, class T = std::initializer_list<S>>
  requires requirement::is_target<M, S, T> && requirement::has_lengths<M, S>
auto shortest_path(const M& m, std::initializer_list<S> sources, const T& target,  // may_cross: not of a bare graph
                   const shortest_path_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  const detail::graph_of<M, S> g{m};
  return detail::shortest_path(g, sources, target, detail::default_lengths(g), options);
}

template<class M, class S, class L, class T = std::initializer_list<S>>
  requires requirement::is_target<M, S, T> && requirement::is_length<L, detail::node_of<M, S>>
auto shortest_path(const M& m, std::initializer_list<S> sources, const T& target,  // may_cross: not of a bare graph
                   const L& length,
                   const shortest_path_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  return detail::shortest_path(detail::graph_of<M, S>{m}, sources, target, detail::input_lengths<L>{length}, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void shortest_path(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void shortest_path(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void shortest_path(mistake::no_points<"the mesh has no points (Embedded), so its edges have no lengths: pass a callable that returns lengths, shortest_path(m, source, target, length)">, ...) = delete;

}  // namespace concino
