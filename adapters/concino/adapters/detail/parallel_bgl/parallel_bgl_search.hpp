// Shortest paths on distributed meshes by the delta-stepping of Parallel BGL.
#pragma once

#include <concino/adapters/detail/parallel_bgl/parallel_bgl_nodes.hpp>

#include <boost/graph/distributed/delta_stepping_shortest_paths.hpp>
#include <boost/property_map/property_map.hpp>

#include <mpi.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

/// What a search finds for the vertices of this process.
struct found_paths {
  std::vector<double> distances;  // the greatest double where unreached
  std::vector<distributed_arcs::vertex_descriptor> predecessors;
};

/// Adds a vertex without node to each process, with arcs of length 0 to its sources, and on the first process to these
/// vertices of all others. A search starts there, since that of Boost has one source. Returns the start. Collective.
template<class G>
distributed_arcs::vertex_descriptor join_sources(const G& g, const distributed_nodes<G>& nodes,
                                                 const std::vector<char>& is_source, arc_lists& lists) {
  int size = 1;
  (MPI_Comm_size)(g.m.communicator(), &size);
  std::vector<std::uint64_t> counts(static_cast<std::size_t>(size));
  const std::uint64_t own = nodes.own.size();
  (MPI_Allgather)(&own, 1, MPI_UINT64_T, counts.data(), 1, MPI_UINT64_T, g.m.communicator());
  const auto last_of = [&](int r) {
    return distributed_arcs::vertex_descriptor(static_cast<boost::processor_id_type>(r),
                                               static_cast<std::size_t>(counts[static_cast<std::size_t>(r)]));
  };
  for (const auto& x : nodes.own)
    if (is_source[g.index(x)]) lists.add(nodes.vertices[g.index(x)], 0);
  if (g.m.rank() == 0)
    for (int r = 1; r < size; ++r) lists.add(last_of(r), 0);
  lists.end_vertex();
  return last_of(0);
}

/// The width of buckets of distances: the power of two that is at most the longest length. Quotients by a power of two
/// are exact, so a path whose last arc is longer than that never stays in the bucket that it leaves, which Boost's
/// implementation relies on. Collective.
inline double bucket_width(MPI_Comm communicator, double max_length) {
  (MPI_Allreduce)(MPI_IN_PLACE, &max_length, 1, MPI_DOUBLE, MPI_MAX, communicator);
  return max_length > 0 ? std::ldexp(1.0, std::ilogb(max_length)) : 1;
}

inline found_paths shortest_paths(const distributed_arcs& g, const distributed_arcs::vertex_descriptor& start,
                                  double width) {
  found_paths r{std::vector<double>(num_vertices(g)),
                std::vector<distributed_arcs::vertex_descriptor>(num_vertices(g))};
  const auto predecessors =
      boost::make_iterator_property_map(r.predecessors.data(), get(boost::vertex_local, g));  // only put at own ones
  boost::graph::distributed::delta_stepping_shortest_paths(g, start, predecessors, distributed_values(g, r.distances),
                                                           arc_lengths(), width);
  return r;
}

/// Writes the predecessor of each local node: the node itself for sources, unreached nodes and ghosts.
template<class G, class Map, class Options>
void put_predecessors(const G& g, const distributed_nodes<G>& nodes, const std::vector<char>& is_source,
                      const found_paths& paths, const Map& distance, const Options& options) {
  for (const auto x : g.nodes()) options.predecessors.put(x, x);
  for (std::size_t k = 0; k < nodes.own.size(); ++k) {
    const auto& x = nodes.own[k];
    if (is_source[g.index(x)] || std::isinf(distance[x])) continue;
    for (const auto y : g.neighbours(x))
      if (nodes.vertices[g.index(y)] == paths.predecessors[k]) options.predecessors.put(x, y);
  }
}

/// Distances from the sources that any process gives, at all local nodes; +inf beyond max_distance. Collective.
template<class G, class S, class Lengths, class Options>
auto distributed_search(const G& g, const S& sources, const Lengths& lengths, const Options& options,
                        double max_distance, const char* caller) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<char> is_source = mark_sources(g, sources, caller);
  const distributed_nodes<G> nodes(g);
  arc_lists lists = arcs_of(g, nodes, is_source, lengths, options, caller);
  const auto start = join_sources(g, nodes, is_source, lists);
  const double width = bucket_width(g.m.communicator(), lists.max_length);
  const distributed_arcs arcs(g.m.communicator(), std::move(lists.ends), std::move(lists.arcs));
  const found_paths paths = shortest_paths(arcs, start, width);
  auto distance = make_node_map<double>(g, infinity);
  for (std::size_t k = 0; k < nodes.own.size(); ++k) {
    const double d = paths.distances[k];
    if (d <= max_distance && d < std::numeric_limits<double>::max()) distance[nodes.own[k]] = d;
  }
  exchange_ghosts(distance);
  if (options.predecessors) put_predecessors(g, nodes, is_source, paths, distance, options);
  return distance;
}

}  // namespace concino::detail
