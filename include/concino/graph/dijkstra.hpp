// Shortest paths by Dijkstra's algorithm: the distance of every node, along edges or from poly to poly.
#pragma once

#include <concino/core/function_ref.hpp>
#include <concino/core/indexed_heap.hpp>
#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/graph/detail/for_each.hpp>
#include <concino/graph/detail/graph_of.hpp>
#include <concino/graph/detail/lengths.hpp>
#include <concino/graph/detail/targets.hpp>
#include <concino/graph/predecessors.hpp>

#include <limits>
#include <type_traits>
#include <vector>

namespace concino {

/// Node is a vert (primal graph) or a poly (dual graph). Crossed is what lies between two of them: an edge, or a face
/// between polys of a volume; void if the mesh has no access to it.
template<class Node, class Crossed = void>
struct dijkstra_options {
  std::vector<Node> targets = {};                // stop when all of them are reached; none: search everything
  bool nearest_target = false;                   // stop when one of them is reached
  function_ref<bool(Node)> may_enter = nullptr;  // false: no path may enter this node (empty: all may be entered).
                                                 // Sources are exempt.
  detail::may_cross_t<Crossed> may_cross = nullptr;                   // false: no path may cross this edge or face
                                                                      // (empty: all may be crossed)
  predecessors_ref<Node> predecessors = nullptr;                      // pointer to a map of nodes by nodes, filled with
                                                                      // the last node but one of each path
  crossed_ref<Node, Crossed> crossed = nullptr;                       // pointer to a map of nodes by edges or faces,
                                                                      // filled with the last one on each path
  function_ref<bool(Node, double)> visit = nullptr;                   // called with each node and its distance, nearest
                                                                      // first; false: stop (empty: never)
  function_ref<double(Node)> initial_distance = nullptr;              // of each source, in units of length, any sign;
                                                                      // +inf: none (empty: 0 for all)
  double max_distance = std::numeric_limits<double>::infinity();      // >= 0, in units of length; nodes farther than
                                                                      // this are not reached
};

namespace detail {

template<class G>
[[noreturn, gnu::noinline, gnu::cold]] void throw_bad_length(const G& g, const typename G::node& from,
                                                             const typename G::node& to, double length,
                                                             const char* caller) {
  core::throw_joined<invalid_mesh>({caller, ": the length from ", name_of(g, from), " to ", name_of(g, to), " is ",
                                    length < 0 ? core::number_text(length) : std::string("not a number"),
                                    "; lengths must be 0 or more"});
}

/// The initial distance of a source.
/// Errors: invalid_argument if it is not a number or is -inf.
template<class Options, class G>
double initial_distance_of(const Options& options, const G& g, const typename G::node& source, const char* caller) {
  if (!options.initial_distance) return 0;
  const double d = options.initial_distance(source);
  if (d > -std::numeric_limits<double>::infinity()) return d;
  core::throw_joined<invalid_argument>({caller, ": the initial distance of ", name_of(g, source), " is ",
                                        d < 0 ? "-inf" : "not a number", "; give a number, or +inf for no source"});
}

/// Full: with may_enter, may_cross, predecessors, crossed and visit, which are otherwise not even tested.
template<bool Full, class G, class S, class L>
auto search_by_length(const G& g, const S& sources, const L& lengths,
                      const dijkstra_options<typename G::node, crossed_t<G>>& options, const char* caller) {
  using node = typename G::node;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  [[maybe_unused]] const auto predecessors = options.predecessors;
  auto distance = make_node_map<double>(g, infinity);
  core::indexed_heap<node> queue(distance.values());
  for_each_source(g, sources, caller, [&](const node& s) {
    const double d = initial_distance_of(options, g, s, caller);
    if (const auto slot = g.index(s); d < queue.key(slot)) queue.decrease_key(s, slot, d);
  });
  target_set targets(g, options.targets, options.nearest_target, caller);
  if constexpr (Full) {
    if (predecessors)
      for (const node x : g.nodes()) predecessors.put(x, x);
  }

  double limit = options.max_distance;
  while (!queue.empty() && queue.min_key() <= limit) {
    const auto [v, v_slot, d] = queue.pop();
    if (targets.meet(v_slot)) limit = d;
    if constexpr (Full) {
      if (options.visit && !options.visit(v, d)) break;
    }
    const auto length_to = lengths.from(v);
    const auto relax = [&, from = v, far = d](const node& w, [[maybe_unused]] const auto& put_crossed) {
      const auto w_slot = g.index(w);
      const double known = queue.key(w_slot);
      const double length = length_to(w, known - far);
      if (!(length >= 0)) throw_bad_length(g, from, w, length, caller);
      if (far + length < known) {
        queue.decrease_key(w, w_slot, far + length);
        if constexpr (Full) {
          if (predecessors) predecessors.put(w, from);
          put_crossed();
        }
      }
    };
    if constexpr (Full) for_each_recorded_neighbour(g, v, options, relax);
    else detail::for_each(g.neighbours(v), [&](const node& w) { relax(w, [] {}); });
  }
  queue.discard_waiting([&]([[maybe_unused]] const node& x) {
    if constexpr (Full) {
      if (predecessors) predecessors.put(x, x);
    }
  });
  return distance;
}

template<class G, class S, class L>
auto dijkstra(const G& g, const S& sources, const L& lengths,
              const dijkstra_options<typename G::node, crossed_t<G>>& options, const char* caller = "dijkstra") {
  if (!(options.max_distance >= 0)) core::throw_joined<invalid_argument>({caller, ": max_distance must be 0 or more"});
  const bool full = options.may_enter || options.may_cross || options.predecessors || options.crossed || options.visit;
  return full ? search_by_length<true>(g, sources, lengths, options, caller)
              : search_by_length<false>(g, sources, lengths, options, caller);
}

}  // namespace detail

/// Shortest distances from `source` along edges (source a vert) or from poly to poly (source a poly). With several
/// sources, in a container or braces, the distance from the nearest one. Without a length function, an arc has the
/// Euclidean length between the verts, or between the means of the verts of the polys.
/// Needs:  PrimalGraph M for verts, DualGraph M for polys; length(from, to) >= 0. Without a length: Embedded, and
///         AnyMesh for polys. may_cross and crossed need the edges or faces of an AnyMesh.
/// Result: a map of double: distance[x] in units of length, +inf where unreached. With targets, it is exact for all
///         nodes that are not farther than the farthest target, or with nearest_target than the nearest, and +inf for
///         the others. It does not depend on the order of elements of equal distance. If several predecessors give
///         equally short paths, the one settled first is stored; it is the same in every run. With initial distances, a
///         source with a shorter path from another source no longer counts as a source. When visit(x, distance) returns
///         false, only the nodes for which it was called are reached.
/// Cost:   O(E log V) time, O(V) memory.
/// Errors: invalid_mesh if a source or target is not an element of m, or if a length that the search reads is negative
///         or not a number. invalid_argument if there is no source, max_distance is negative or not a number, or an
///         initial distance is not a number or -inf.
/// Source: Dijkstra 1959; paper section 2.2, "Distances and paths".
template<class M, class S>
  requires requirement::is_lvalue_or_view<M> && requirement::has_lengths<M, S>
auto dijkstra(M&& m, const S& source,  // may_cross, crossed: not of a bare graph
              const dijkstra_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  const detail::graph_of<M, S> g{m};
  return detail::dijkstra(g, source, detail::default_lengths(g), options);
}

template<class M, class S, class L>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S> &&
      requirement::is_length<L, detail::node_of<M, S>>
auto dijkstra(M&& m, const S& source, const L& length,  // may_cross, crossed: not of a bare graph
              const dijkstra_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  return detail::dijkstra(detail::graph_of<M, S>{m}, source, detail::input_lengths<L>{length}, options);
}

template<class M, class S>
  requires requirement::is_lvalue_or_view<M> && requirement::has_lengths<M, S>
auto dijkstra(M&& m, std::initializer_list<S> sources,  // may_cross, crossed: not of a bare graph
              const dijkstra_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  const detail::graph_of<M, S> g{m};
  return detail::dijkstra(g, sources, detail::default_lengths(g), options);
}

template<class M, class S, class L>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S> &&
      requirement::is_length<L, detail::node_of<M, S>>
auto dijkstra(M&& m, std::initializer_list<S> sources, const L& length,  // may_cross, crossed: not of a bare graph
              const dijkstra_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  return detail::dijkstra(detail::graph_of<M, S>{m}, sources, detail::input_lengths<L>{length}, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void dijkstra(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void dijkstra(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void dijkstra(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void dijkstra(mistake::no_points<"the mesh has no points (Embedded), so its edges have no lengths: pass a callable that returns lengths, dijkstra(m, source, length)">, ...) = delete;

}  // namespace concino
