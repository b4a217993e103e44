// Breadth-first search: how many steps away is everything.
#pragma once

#include <concino/core/function_ref.hpp>
#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/graph/detail/crossings.hpp>
#include <concino/graph/detail/fetch.hpp>
#include <concino/graph/detail/for_each_in.hpp>
#include <concino/graph/detail/once_queue.hpp>
#include <concino/graph/detail/targets.hpp>
#include <concino/graph/predecessors.hpp>

#include <limits>
#include <vector>

namespace concino {

/// Node is a vert (primal graph) or a poly (dual graph); Crossed what lies between two of them: an edge, between polys of a volume a face;
/// void where the mesh does not offer it.
template<class Node, class Crossed = void>
struct bfs_options {
  std::vector<Node> targets = {};                // stop when all of them are reached; none: go everywhere
  bool nearest_target = false;                   // stop when one of them is reached
  function_ref<bool(Node)> may_enter = nullptr;  // false: the search does not step on this node (empty: it may on all). Sources are exempt.
  detail::may_cross_t<Crossed> may_cross = nullptr;  // false: the search does not step across this edge or face (empty: it may across all)
  predecessors_ref<Node> predecessors = nullptr;     // pointer to a map of nodes by nodes, filled with where each was reached from
  int max_hops = std::numeric_limits<int>::max();    // >= 0; no step beyond this many
};

namespace detail {

/// The search without what costs time in its loop when nobody asked for it.
template<bool Asks, class G, class S>
auto plain_bfs(const G& g, const S& sources, [[maybe_unused]] function_ref<bool(typename G::node)> may_enter) {
  using node = typename G::node;
  auto hops = make_node_map<int>(g, -1);
  int* const value = hops.values().data();
  once_queue<node> queue(g.bound());

  for_each_source(g, sources, "bfs", [&](const node& s) {
    if (int& h = value[g.index(s)]; h < 0) {
      h = 0;
      queue.push(s);
    }
  });
  while (!queue.empty()) {
    const node v = queue.pop();
    const int next = value[g.index(v)] + 1;
    if constexpr (lies_in_memory<decltype(g.neighbours(v))>) {
      if (const node* const later = queue.ahead(4)) fetch(row_of(g.neighbours(*later)));
    }
    for_each_with_repeats_in(g.neighbours(v), [&](const node& w) {
      int& h = value[g.index(w)];
      if (h >= 0) return;
      if constexpr (Asks)
        if (!may_enter(w)) return;
      h = next;
      queue.push(w);
    });
  }
  return hops;
}

/// The same search with everything.
template<class G, class S>
auto full_bfs(const G& g, const S& sources, const bfs_options<typename G::node, crossed_t<G>>& options) {
  using node = typename G::node;
  auto hops = make_node_map<int>(g, -1);
  int* const value = hops.values().data();
  once_queue<node> queue(g.bound());
  target_set targets(g, options.targets, options.nearest_target, "bfs");
  int limit = options.max_hops;

  const auto reach = [&](const node& x, const node& before, int h) {
    const auto slot = g.index(x);
    if (value[slot] >= 0) return;
    value[slot] = h;
    queue.push(x);
    if (options.predecessors) options.predecessors.put(x, before);
    if (targets.meet(slot)) limit = h;
  };
  if (options.predecessors)
    for (const node x : g.nodes()) options.predecessors.put(x, x);
  for_each_source(g, sources, "bfs", [&](const node& s) { reach(s, s, 0); });
  while (!queue.empty()) {
    const node v = queue.pop();
    const int h = value[g.index(v)];
    if (h >= limit) break;
    for_each_step(g, v, options.may_enter, options.may_cross, [&](const node& w) { reach(w, v, h + 1); });
  }
  return hops;
}

template<class G, class S>
auto bfs(const G& g, const S& sources, const bfs_options<typename G::node, crossed_t<G>>& options) {
  if (options.max_hops < 0) core::throw_joined<invalid_argument>({"bfs: max_hops is ", core::number_text(options.max_hops), "; it must be 0 or more"});
  const bool plain = options.targets.empty() && !options.may_cross && !options.predecessors && options.max_hops == std::numeric_limits<int>::max();
  if (!plain) return full_bfs(g, sources, options);
  return options.may_enter ? plain_bfs<true>(g, sources, options.may_enter) : plain_bfs<false>(g, sources, nullptr);
}

}  // namespace detail

/// Fewest steps from `source` along edges (source a vert) or from poly to poly (source a poly); from the nearest of several sources
/// where a container or braces of them are given.
/// Needs:  PrimalGraph M for verts, DualGraph M for polys; may_cross needs the edges or faces of an AnyMesh.
/// Result: a map of int: hops[x], 0 at the sources, -1 where unreached. With targets, it is complete up to the farthest target, or with
///         nearest_target up to the nearest, and -1 beyond. The predecessor of a node is the first among those one step nearer that was
///         reached; sources are reached in their order, the neighbours of a node in that of the mesh.
/// Cost:   O(V + E) time, O(V) memory.
/// Errors: invalid_mesh if a source or target is not an element of m; invalid_argument if there is no source or max_hops < 0.
/// Source: Moore 1959; paper section 2.1, "Architecture".
template<class M, class S>
  requires requirement::is_no_temporary<M> && requirement::is_source<M, S>
auto bfs(M&& m, const S& source, const bfs_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {  // may_cross: not of a bare graph, which has no edges or faces to cross
  return detail::bfs(detail::graph_of<M, S>{m}, source, options);
}

template<class M, class S>
  requires requirement::is_no_temporary<M> && requirement::is_source<M, S>
auto bfs(M&& m, std::initializer_list<S> sources, const bfs_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {  // may_cross: not of a bare graph, which has no edges or faces to cross
  return detail::bfs(detail::graph_of<M, S>{m}, sources, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void bfs(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling
template<class... T> void bfs(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void bfs(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino
