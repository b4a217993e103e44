// Shortest paths: how far away is everything, along edges or from poly to poly.
#pragma once

#include <concino/function_ref.hpp>
#include <concino/graph/detail/graph_of.hpp>
#include <concino/graph/detail/indexed_heap.hpp>
#include <concino/graph/detail/lengths.hpp>

#include <limits>
#include <utility>
#include <vector>

namespace concino {

/// Node is a vert (primal graph) or a poly (dual graph).
template<class Node>
struct dijkstra_options {
  std::vector<Node> targets = {};                // stop when all of them are reached; none: go everywhere
  function_ref<bool(Node)> may_enter = nullptr;  // false: no path may step on this node (empty: on all). Sources are exempt.
};

namespace detail {

template<class G>
[[noreturn, gnu::noinline, gnu::cold]] void throw_bad_length(const G& g, const typename G::node& from, const typename G::node& to, double length) {
  throw invalid_mesh("dijkstra: the length from " + name_of(g, from) + " to " + name_of(g, to) + " is " +
                     (length < 0 ? number_text(length) : std::string("not a number")) + "; lengths must be 0 or more");
}

template<class G, class S, class L>
auto dijkstra(const G& g, const S& sources, const L& lengths, const dijkstra_options<typename G::node>& options) {
  using node = typename G::node;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto may_enter = options.may_enter;
  auto distance = make_node_map<double>(g, infinity);
  indexed_heap<node> queue(distance.values());
  for_each_source(g, sources, "dijkstra", [&](const node& s) {
    if (const auto slot = g.index(s); queue.key(slot) == infinity) queue.lower(s, slot, 0);
  });

  std::vector<unsigned char> is_target;
  std::size_t targets_left = 0;
  if (!options.targets.empty()) {
    is_target.resize(g.bound());
    for (const node& t : options.targets) {
      expect_node(g, t, "dijkstra", "target");
      targets_left += !std::exchange(is_target[g.index(t)], static_cast<unsigned char>(1));
    }
  }

  double limit = infinity;
  while (!queue.empty() && queue.least() <= limit) {
    const auto [v, v_slot, d] = queue.pop();
    if (targets_left > 0 && is_target[v_slot] && --targets_left == 0) limit = d;
    const auto length_to = lengths.from(v);
    for (const node w : g.neighbours(v)) {
      if (may_enter && !may_enter(w)) continue;
      const auto w_slot = g.index(w);
      const double known = queue.key(w_slot);
      const double length = length_to(w, known - d);
      if (!(length >= 0)) [[unlikely]] throw_bad_length(g, v, w, length);
      if (d + length < known) queue.lower(w, w_slot, d + length);
    }
  }
  queue.forget_waiting();
  return distance;
}

}  // namespace detail

/// Shortest distances from `source` along edges (source a vert) or from poly to poly (source a poly); from the nearest of several
/// sources where a container or braces of them are given. Without a length, an arc is as long as the straight line between the verts,
/// or between the means of the verts of the polys.
/// Needs:  PrimalGraph M for verts, DualGraph M for polys; length(from, to) >= 0. Without a length: Embedded, and AnyMesh for polys.
/// Result: a map of double: distance[x] in units of length, +inf where unreached. With targets, it is exact for all nodes that are not
///         farther than the farthest target, and +inf for the others. It does not depend on the order of elements of equal distance.
/// Cost:   O(E log V) time, O(V) memory.
/// Errors: invalid_mesh if a source or target is not an element of m, or if a length met on the way is negative or not a number.
/// Source: Dijkstra 1959; paper section 2.2, "Distances and paths".
template<class M, class S, class L>
  requires requirement::is_no_temporary<M> && requirement::is_source<M, S> && requirement::is_length<L, detail::node_of<M, S>>
auto dijkstra(M&& m, const S& source, const L& length, const dijkstra_options<detail::node_of<M, S>>& options = {}) {
  return detail::dijkstra(detail::graph_of<M, S>{m}, source, detail::given_lengths<L>{length}, options);
}

template<class M, class S, class L>
  requires requirement::is_no_temporary<M> && requirement::is_source<M, S> && requirement::is_length<L, detail::node_of<M, S>>
auto dijkstra(M&& m, std::initializer_list<S> sources, const L& length, const dijkstra_options<detail::node_of<M, S>>& options = {}) {
  return detail::dijkstra(detail::graph_of<M, S>{m}, sources, detail::given_lengths<L>{length}, options);
}

template<class M, class S>
  requires requirement::is_no_temporary<M> && requirement::has_lengths<M, S>
auto dijkstra(M&& m, const S& source, const dijkstra_options<detail::node_of<M, S>>& options = {}) {
  const detail::graph_of<M, S> g{m};
  return detail::dijkstra(g, source, detail::default_lengths(g), options);
}

template<class M, class S>
  requires requirement::is_no_temporary<M> && requirement::has_lengths<M, S>
auto dijkstra(M&& m, std::initializer_list<S> sources, const dijkstra_options<detail::node_of<M, S>>& options = {}) {
  const detail::graph_of<M, S> g{m};
  return detail::dijkstra(g, sources, detail::default_lengths(g), options);
}

}  // namespace concino
