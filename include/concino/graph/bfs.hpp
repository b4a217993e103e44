// Breadth-first search: how many steps away is everything.
#pragma once

#include <concino/function_ref.hpp>
#include <concino/graph/detail/graph_of.hpp>
#include <concino/graph/detail/once_queue.hpp>

namespace concino {

/// Node is a vert (primal graph) or a poly (dual graph).
template<class Node>
struct bfs_options {
  function_ref<bool(Node)> may_enter = nullptr;  // false: the search does not step on this node (empty: it may on all). Sources are exempt.
};

namespace detail {

template<class G, class S>
auto bfs(const G& g, const S& sources, const bfs_options<typename G::node>& options) {
  using node = typename G::node;
  const auto may_enter = options.may_enter;
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
    for (const node w : g.neighbours(v)) {
      int& h = value[g.index(w)];
      if (h >= 0 || (may_enter && !may_enter(w))) continue;
      h = next;
      queue.push(w);
    }
  }
  return hops;
}

}  // namespace detail

/// Fewest steps from `source` along edges (source a vert) or from poly to poly (source a poly); from the nearest of several sources
/// where a container or braces of them are given.
/// Needs:  PrimalGraph M for verts, DualGraph M for polys.
/// Result: a map of int: hops[x], 0 at the sources, -1 where unreached.      Cost: O(V + E) time, O(V) memory.
/// Errors: invalid_mesh if a source is not an element of m.
/// Source: Moore 1959; paper section 2.1, "Mesh hierarchy".
template<class M, class S>
  requires requirement::is_no_temporary<M> && requirement::is_source<M, S>
auto bfs(M&& m, const S& source, const bfs_options<detail::node_of<M, S>>& options = {}) {
  return detail::bfs(detail::graph_of<M, S>{m}, source, options);
}

template<class M, class S>
  requires requirement::is_no_temporary<M> && requirement::is_source<M, S>
auto bfs(M&& m, std::initializer_list<S> sources, const bfs_options<detail::node_of<M, S>>& options = {}) {
  return detail::bfs(detail::graph_of<M, S>{m}, sources, options);
}

}  // namespace concino
