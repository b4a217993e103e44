// Breadth-first search: the number of steps to every node, the order of the search, and predecessors.
#pragma once

#include <concino/core/function_ref.hpp>
#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/graph/detail/bounded_fifo.hpp>
#include <concino/graph/detail/crossings.hpp>
#include <concino/graph/detail/for_each.hpp>
#include <concino/graph/detail/targets.hpp>
#include <concino/graph/predecessors.hpp>

#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

/// Node is a vert (primal graph) or a poly (dual graph). Crossed is what lies between two of them: an edge, or a face
/// between polys of a volume; void if the mesh has no access to it.
template<class Node, class Crossed = void>
struct bfs_options {
  std::vector<Node> targets = {};                // stop when all of them are reached; none: search everything
  bool nearest_target = false;                   // stop when one of them is reached
  function_ref<bool(Node)> may_enter = nullptr;  // false: the search does not enter this node (empty: it may enter
                                                 // all). Sources are exempt.
  detail::may_cross_t<Crossed> may_cross = nullptr;  // false: the search does not cross this edge or face (empty: it
                                                     // may cross all)
  predecessors_ref<Node> predecessors = nullptr;     // pointer to a map of nodes by nodes, filled with the predecessor
                                                     // of each
  crossed_ref<Node, Crossed> crossed = nullptr;      // pointer to a map of nodes by edges or faces, filled with the one
                                                     // crossed to reach each
  function_ref<bool(Node, int)> visit = nullptr;     // called with each node and its hops when it is reached; false:
                                                     // stop the search (empty: never)
  int max_hops = std::numeric_limits<int>::max();    // >= 0; nodes farther than this are not reached
};

namespace detail {

/// The search without the optional features that slow down its loop.
template<bool Asks, class G, class S>
auto plain_bfs(const G& g, const S& sources, [[maybe_unused]] function_ref<bool(typename G::node)> may_enter) {
  using node = typename G::node;
  auto hops = make_node_map<int>(g, -1);
  int* const value = hops.data();
  bounded_fifo<node> queue(g.bound());

  for_each_source(g, sources, "bfs", [&](const node& s) {
    if (int& h = value[g.index(s)]; h < 0) {
      h = 0;
      queue.push(s);
    }
  });
  while (!queue.empty()) {
    const node v = queue.pop();
    const int next = value[g.index(v)] + 1;
    for_each_with_repeats(g.neighbours(v), [&](const node& w) {
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

/// Tag for the sources of a forest: each tree starts at the first node that is not reached yet.
struct all_nodes {};

/// The same search with all options. Reports: with crossed and visit too, which take time even if they are not used.
template<bool Reports, class G, class S>
auto full_bfs(const G& g, const S& sources, const bfs_options<typename G::node, crossed_t<G>>& options) {
  using node = typename G::node;
  auto hops = make_node_map<int>(g, -1);
  int* const value = hops.data();
  bounded_fifo<node> queue(g.bound());
  target_set targets(g, options.targets, options.nearest_target, "bfs");
  int limit = options.max_hops;  // maximum number of hops; -1 when visit has ended the search
  bool is_over = false;

  const auto mark_reached = [&](const node& x, const node& before, int h, [[maybe_unused]] const auto& put_crossed) {
    const auto slot = g.index(x);
    if (value[slot] >= 0 || (Reports && h > limit)) return;
    value[slot] = h;
    queue.push(x);
    if (options.predecessors) options.predecessors.put(x, before);
    if constexpr (Reports) put_crossed();
    if (targets.meet(slot)) {
      limit = h;
      is_over = true;
    }
    if constexpr (Reports) {
      if (options.visit && !options.visit(x, h)) {
        limit = -1;
        is_over = true;
      }
    }
  };
  [[maybe_unused]] auto&& nodes = g.nodes();
  [[maybe_unused]] auto root = nodes.begin();
  const auto reach_next_root = [&] {  // of a forest
    if constexpr (std::same_as<S, all_nodes>) {
      for (; !is_over && root != nodes.end(); ++root) {
        const node x = *root;
        if (value[g.index(x)] >= 0 || (options.may_enter && !options.may_enter(x))) continue;
        mark_reached(x, x, 0, [] {});
        return true;
      }
    }
    return false;
  };

  if (options.predecessors)
    for (const node x : g.nodes()) options.predecessors.put(x, x);
  if constexpr (!std::same_as<S, all_nodes>)
    for_each_source(g, sources, "bfs", [&](const node& s) { mark_reached(s, s, 0, [] {}); });
  while (!queue.empty() || reach_next_root()) {
    const node v = queue.pop();
    const int h = value[g.index(v)];
    if (h >= limit) continue;
    if constexpr (Reports)
      for_each_recorded_neighbour(
          g, v, options, [&](const node& w, const auto& put_crossed) { mark_reached(w, v, h + 1, put_crossed); });
    else
      for_each_open_neighbour(g, v, options.may_enter, options.may_cross,
                              [&](const node& w) { mark_reached(w, v, h + 1, [] {}); });
  }
  return hops;
}

template<class Node, class Crossed>
void check_bfs(const bfs_options<Node, Crossed>& options, const char* caller) {
  if (options.max_hops < 0)
    core::throw_joined<invalid_argument>(
        {caller, ": max_hops is ", core::number_text(options.max_hops), "; it must be 0 or more"});
}

template<class G, class S>
auto bfs(const G& g, const S& sources, const bfs_options<typename G::node, crossed_t<G>>& options) {
  check_bfs(options, "bfs");
  const bool plain = options.targets.empty() && !options.may_cross && !options.predecessors && !options.crossed &&
                     !options.visit && options.max_hops == std::numeric_limits<int>::max();
  if (plain)
    return options.may_enter ? plain_bfs<true>(g, sources, options.may_enter) : plain_bfs<false>(g, sources, nullptr);
  return options.crossed || options.visit ? full_bfs<true>(g, sources, options) : full_bfs<false>(g, sources, options);
}

template<class G>
auto bfs_forest(const G& g, const bfs_options<typename G::node, crossed_t<G>>& options) {
  check_bfs(options, "bfs_forest");
  return full_bfs<true>(g, all_nodes{}, options);
}

}  // namespace detail

/// Fewest steps from `source` along edges (source a vert) or from poly to poly (source a poly). With several sources,
/// in a container or braces, the steps from the nearest one.
/// Needs:  PrimalGraph M for verts, DualGraph M for polys; may_cross and crossed need the edges or faces of an AnyMesh.
/// Result: a map of int: hops[x], 0 at the sources, -1 where unreached. With targets, it is complete up to the farthest
///         target, or with nearest_target up to the nearest, and -1 beyond. The predecessor of a node is the one that
///         was reached first among the neighbours one step nearer. Sources are reached in their order. The neighbours
///         of a node are reached in the order of the mesh, or in that of the edges or faces around it if `crossed` or
///         may_cross is set. When visit(x, hops) returns false, only the nodes for which it was called count as
///         reached.
/// Cost:   O(V + E) time, O(V) memory.
/// Errors: invalid_mesh if a source or target is not an element of m; invalid_argument if there is no source or
///         max_hops < 0.
/// Source: Moore 1959; paper section 2.1, "Architecture".
template<class M, class S>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S>
auto bfs(M&& m, const S& source) {  // without options the search with everything is not compiled
  return detail::plain_bfs<false>(detail::graph_of<M, S>{m}, source, nullptr);
}
template<class M, class S>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S>
auto bfs(M&& m, std::initializer_list<S> sources) {
  return detail::plain_bfs<false>(detail::graph_of<M, S>{m}, sources, nullptr);
}

template<class M, class S>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S>
auto bfs(M&& m, const S& source,  // may_cross, crossed: not of a bare graph
         const bfs_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options) {
  return detail::bfs(detail::graph_of<M, S>{m}, source, options);
}

template<class M, class S>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S>
auto bfs(M&& m, std::initializer_list<S> sources,  // may_cross, crossed: not of a bare graph
         const bfs_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options) {
  return detail::bfs(detail::graph_of<M, S>{m}, sources, options);
}

/// Breadth-first forest of a whole graph: a search from the first node, then from the first that is not reached yet,
/// and so on. Nodes are the verts of a mesh, or its polys if the argument is dual(m).
/// Needs:  PrimalGraph M, or dual(m) of a DualGraph m; may_cross and crossed need the edges or faces of an AnyMesh.
/// Result: a map of int: hops[x] from the root of the tree of x, 0 at the roots, -1 where may_enter is false. The nodes
///         of a tree are reached one after another, in the order of bfs, so visit(x, 0) is the start of the next tree.
///         With max_hops no tree is higher than that: nodes farther away start trees of their own. When targets are
///         reached or visit returns false, no further tree starts.
/// Cost:   O(V + E) time, O(V) memory.
/// Errors: invalid_mesh if a target is not an element of m; invalid_argument if max_hops < 0.
/// Source: Moore 1959.
template<class M>
  requires requirement::is_lvalue_or_view<M> && requirement::is_graph<M>
auto bfs_forest(  // may_cross, crossed: not of a bare graph
    M&& m,
    const bfs_options<detail::default_node_of<M>, detail::crossed_t<detail::default_graph_of<M>>>& options = {}) {
  return detail::bfs_forest(detail::default_graph_of<M>{m}, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void bfs(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void bfs(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void bfs_forest(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void bfs_forest(mistake::polys_alone<mistake::name_dual>, ...) = delete;  // of a graph of polys alone write bfs_forest(dual(m))
template<class... T> void bfs_forest(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void bfs(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino
