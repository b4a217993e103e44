// Walks on distributed meshes by Parallel BGL: bfs(d, sources), dijkstra(d, sources), connected_components(d).
// With this header, they mean the whole mesh; without it, the local mesh alone.
// Needs: Boost's Parallel BGL and Boost.MPI (Debian: libboost-graph-parallel-dev, libboost-mpi-dev), and MPI.
#pragma once

#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/parallel_bgl/parallel_bgl_components.hpp>
#include <concino/adapters/detail/parallel_bgl/parallel_bgl_search.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/graph/components.hpp>
#include <concino/graph/dijkstra.hpp>

#include <cmath>
#include <initializer_list>
#include <type_traits>

namespace concino {

namespace requirement {

/// A distributed mesh d, or primal(d) or dual(d).
template<class M>
concept is_distributed = concino::detail::is_distributed_mesh<concino::detail::base_mesh_t<std::remove_cvref_t<M>>>;

}  // namespace requirement

namespace detail {

template<class Options>
void check_distributed_options(const Options& options, const char* caller) {
  if (!options.targets.empty() || options.visit || options.crossed)
    core::throw_joined<unsupported>({caller, ": targets, visit and crossed are not for distributed meshes"});
}

template<class G, class S, class Options>
auto distributed_bfs(const G& g, const S& sources, const Options& options) {
  on_all(g.m.communicator(), [&] {
    check_bfs(options, "bfs");
    check_distributed_options(options, "bfs");
  });
  const auto steps = distributed_search(g, sources, unit_lengths(), options, options.max_hops, "bfs");
  auto hops = make_node_map<int>(g, -1);
  for (const auto x : g.nodes())
    if (!std::isinf(steps[x])) hops[x] = static_cast<int>(steps[x]);
  return hops;
}

template<class G, class S, class Lengths, class Options>
auto distributed_dijkstra(const G& g, const S& sources, const Lengths& lengths, const Options& options) {
  on_all(g.m.communicator(), [&] {
    if (!(options.max_distance >= 0)) throw invalid_argument("dijkstra: max_distance must be 0 or more");
    check_distributed_options(options, "dijkstra");
    if (options.initial_distance) throw unsupported("dijkstra: initial_distance is not for distributed meshes");
  });
  return distributed_search(g, sources, lengths, options, options.max_distance, "dijkstra");
}

}  // namespace detail

/// bfs of the whole mesh, which all its processes compute together.
/// Needs:  a distributed mesh d, primal(d) or dual(d), of at most 32,767 processes. source: local verts, or local
///         polys; each process gives those of its own, none or several, and may repeat those of its ghosts. Options are
///         the same on all processes, and so is what may_enter and may_cross answer.
/// Result: hops[x] as bfs of the mesh that was divided, at local verts or polys, ghosts included. Of predecessors that
///         are equally near any one is stored; that of a ghost is the ghost itself, so that paths end where another
///         process continues them.
/// Cost:   O(V + E) time and memory of the part: 24 bytes for each arc. Some messages to and from each process for each
///         step.
/// Errors: as bfs, thrown on all processes. unsupported with targets, visit or crossed.
/// Source: Meyer, Sanders 2003, with unit lengths: each bucket is a step of the search.
template<class M, class S>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S> && requirement::is_distributed<M>
auto bfs(M&& m, const S& source) {
  return detail::distributed_bfs(detail::graph_of_base(detail::graph_of<M, S>{m}), source,
                                 bfs_options<detail::node_of<M, S>, detail::crossed_of<M, S>>());
}
template<class M, class S>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S> && requirement::is_distributed<M>
auto bfs(M&& m, std::initializer_list<S> sources) {
  return detail::distributed_bfs(detail::graph_of_base(detail::graph_of<M, S>{m}), sources,
                                 bfs_options<detail::node_of<M, S>, detail::crossed_of<M, S>>());
}

template<class M, class S>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S> && requirement::is_distributed<M>
auto bfs(M&& m, const S& source, const bfs_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options) {
  return detail::distributed_bfs(detail::graph_of_base(detail::graph_of<M, S>{m}), source, options);
}

template<class M, class S>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S> && requirement::is_distributed<M>
auto bfs(M&& m, std::initializer_list<S> sources,
         const bfs_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options) {
  return detail::distributed_bfs(detail::graph_of_base(detail::graph_of<M, S>{m}), sources, options);
}

/// dijkstra of the whole mesh, which all its processes compute together.
/// Needs:  as bfs of a distributed mesh; length(from, to) >= 0 and the same on all processes. Without a length:
///         EmbeddedMesh.
/// Result: distance[x] as dijkstra of the mesh that was divided, at local verts or polys, ghosts included. Predecessors
///         as bfs of a distributed mesh.
/// Cost:   as bfs of a distributed mesh; messages for each bucket of distances, which is as wide as the power of two
///         below the longest length, and for each correction in it.
/// Errors: as dijkstra, thrown on all processes; also for lengths between nodes that no path reaches. Elements are
///         named by their global numbers. unsupported with targets, visit, crossed or initial_distance.
/// Source: Meyer, Sanders 2003 (delta-stepping).
template<class M, class S>
  requires requirement::is_lvalue_or_view<M> && requirement::has_lengths<M, S> && requirement::is_distributed<M>
auto dijkstra(M&& m, const S& source,
              const dijkstra_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  const auto g = detail::graph_of_base(detail::graph_of<M, S>{m});
  return detail::distributed_dijkstra(g, source, detail::default_lengths(g), options);
}

template<class M, class S, class L>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S> &&
      requirement::is_length<L, detail::node_of<M, S>> && requirement::is_distributed<M>
auto dijkstra(M&& m, const S& source, const L& length,
              const dijkstra_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  return detail::distributed_dijkstra(detail::graph_of_base(detail::graph_of<M, S>{m}), source,
                                      detail::input_lengths<L>{length}, options);
}

template<class M, class S>
  requires requirement::is_lvalue_or_view<M> && requirement::has_lengths<M, S> && requirement::is_distributed<M>
auto dijkstra(M&& m, std::initializer_list<S> sources,
              const dijkstra_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  const auto g = detail::graph_of_base(detail::graph_of<M, S>{m});
  return detail::distributed_dijkstra(g, sources, detail::default_lengths(g), options);
}

template<class M, class S, class L>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S> &&
      requirement::is_length<L, detail::node_of<M, S>> && requirement::is_distributed<M>
auto dijkstra(M&& m, std::initializer_list<S> sources, const L& length,
              const dijkstra_options<detail::node_of<M, S>, detail::crossed_of<M, S>>& options = {}) {
  return detail::distributed_dijkstra(detail::graph_of_base(detail::graph_of<M, S>{m}), sources,
                                      detail::input_lengths<L>{length}, options);
}

/// connected_components of the whole mesh, which all its processes compute together.
/// Needs:  a distributed mesh d, primal(d) or dual(d), of at most 32,767 processes. What may_enter and may_cross answer
///         is the same on all processes.
/// Result: as connected_components of the mesh that was divided, with cc[x] at local verts or polys, ghosts included:
///         components are numbered by their lowest global number.
/// Cost:   O(V + E) time and memory of the part: 24 bytes for each arc, and 8 bytes for each component of the whole
///         mesh. Messages in O(log(parts of components)) rounds.
/// Errors: none of its own.
/// Source: Boost's implementation of Shiloach, Vishkin 1982, after a search in each part.
template<class M>
  requires requirement::is_lvalue_or_view<M> && requirement::is_graph<M> && requirement::is_distributed<M>
auto connected_components(
    M&& m, const connected_components_options<detail::default_node_of<M>,
                                              detail::crossed_t<detail::default_graph_of<M>>>& options = {}) {
  return detail::find_distributed_components(detail::graph_of_base(detail::default_graph_of<M>{m}), options);
}

}  // namespace concino
