// A distributed graph of Parallel BGL: the arcs of a primal or dual graph of a distributed mesh, of which each process
// has those from its own nodes.
#pragma once

#include <boost/graph/use_mpi.hpp>  // before all others of Boost.Graph

#include <boost/graph/distributed/adjacency_list.hpp>
#include <boost/graph/distributed/mpi_process_group.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/parallel/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <mpi.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

/// Models DistributedGraph, DistributedVertexListGraph, IncidenceGraph and AdjacencyGraph. A vertex is its process and
/// its number there; vertices(g) are those of this process, and targets of arcs may be of other processes.
class distributed_arcs {
 public:
  using process_group_type = boost::graph::distributed::mpi_process_group;
  using vertex_descriptor = boost::detail::parallel::global_descriptor<std::size_t>;
  struct arc {
    vertex_descriptor target;
    double length = 0;
  };
  struct edge_descriptor {
    vertex_descriptor source;
    const arc* place = nullptr;
    friend bool operator==(const edge_descriptor&, const edge_descriptor&) = default;
  };
  struct arc_from {
    vertex_descriptor source;
    edge_descriptor operator()(const arc& a) const { return {source, &a}; }
  };
  struct arc_target {
    vertex_descriptor operator()(const arc& a) const { return a.target; }
  };
  using vertex_iterator =
      boost::transform_iterator<vertex_descriptor::generator, boost::counting_iterator<std::size_t>>;
  using out_edge_iterator = boost::transform_iterator<arc_from, const arc*>;
  using adjacency_iterator = boost::transform_iterator<arc_target, const arc*>;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  struct traversal_category : virtual boost::distributed_graph_tag,
                              virtual boost::distributed_vertex_list_graph_tag,
                              virtual boost::incidence_graph_tag,
                              virtual boost::adjacency_graph_tag {};
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;
  // filtered_graph of Boost names these; none of the algorithms walks them
  using edge_iterator = out_edge_iterator;
  using in_edge_iterator = out_edge_iterator;

  static vertex_descriptor null_vertex() { return {-1, std::numeric_limits<std::size_t>::max()}; }

 private:
  process_group_type group_;
  std::vector<std::size_t> ends_;  // of the arcs from each vertex of this process
  std::vector<arc> arcs_;

  const arc* end_of(std::size_t v) const { return arcs_.data() + ends_[v]; }
  const arc* begin_of(std::size_t v) const { return v == 0 ? arcs_.data() : end_of(v - 1); }

 public:
  /// Collective. Messages are sent in batches of at most so many and so many bytes: with Boost's own sizes, 250 buffers
  /// of 2.6 MB are set aside.
  distributed_arcs(MPI_Comm communicator, std::vector<std::size_t>&& ends, std::vector<arc>&& arcs)
      : group_(1024, 32768, boost::mpi::communicator(communicator, boost::mpi::comm_attach)), ends_(std::move(ends)),
        arcs_(std::move(arcs)) {}
  distributed_arcs(const distributed_arcs&) = delete;
  distributed_arcs& operator=(const distributed_arcs&) = delete;
  /// Boost cancels the requests that wait for further messages, and keeps their memory.
  ~distributed_arcs() {
    for (MPI_Request& request : group_.impl_->requests) {
      (MPI_Cancel)(&request);
      (MPI_Wait)(&request, MPI_STATUS_IGNORE);
    }
    group_.impl_->requests.clear();
  }

  friend const process_group_type& process_group(const distributed_arcs& g) { return g.group_; }
  const process_group_type& process_group() const { return group_; }

  friend std::size_t num_vertices(const distributed_arcs& g) { return g.ends_.size(); }
  friend std::pair<vertex_iterator, vertex_iterator> vertices(const distributed_arcs& g) {
    const vertex_descriptor::generator make(static_cast<boost::processor_id_type>(process_id(g.group_)));
    return {vertex_iterator(boost::counting_iterator<std::size_t>(0), make),
            vertex_iterator(boost::counting_iterator<std::size_t>(g.ends_.size()), make)};
  }
  friend std::size_t out_degree(const vertex_descriptor& v, const distributed_arcs& g) {
    return static_cast<std::size_t>(g.end_of(v.local) - g.begin_of(v.local));
  }
  friend std::pair<out_edge_iterator, out_edge_iterator> out_edges(const vertex_descriptor& v,
                                                                   const distributed_arcs& g) {
    return {out_edge_iterator(g.begin_of(v.local), arc_from{v}), out_edge_iterator(g.end_of(v.local), arc_from{v})};
  }
  friend std::pair<adjacency_iterator, adjacency_iterator> adjacent_vertices(const vertex_descriptor& v,
                                                                             const distributed_arcs& g) {
    return {adjacency_iterator(g.begin_of(v.local), arc_target()), adjacency_iterator(g.end_of(v.local), arc_target())};
  }
  friend vertex_descriptor source(const edge_descriptor& e, const distributed_arcs&) { return e.source; }
  friend vertex_descriptor target(const edge_descriptor& e, const distributed_arcs&) { return e.place->target; }

  friend auto get(boost::vertex_owner_t, const distributed_arcs&) {
    return boost::detail::parallel::owner_property_map<std::size_t>();
  }
  friend auto get(boost::vertex_local_t, const distributed_arcs&) {
    return boost::detail::parallel::local_descriptor_property_map<std::size_t>();
  }
  friend auto get(boost::vertex_global_t, const distributed_arcs&) {
    return boost::detail::parallel::global_descriptor_property_map<std::size_t>();
  }
  friend auto get(boost::vertex_index_t, const distributed_arcs& g) { return get(boost::vertex_local, g); }
};

/// The length of each arc, as a property map of Boost.
struct arc_lengths {
  using key_type = distributed_arcs::edge_descriptor;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;
  friend double get(const arc_lengths&, const key_type& e) { return e.place->length; }
};

/// A value for each vertex of the graph, as a property map of Parallel BGL: values[i] is that of vertex i of this
/// process; those of other processes come by messages. Collective.
template<class T>
auto distributed_values(const distributed_arcs& g, std::vector<T>& values) {
  auto own = boost::make_iterator_property_map(values.data(), boost::typed_identity_property_map<std::size_t>());
  using global = decltype(get(boost::vertex_global, g));
  return boost::parallel::distributed_property_map<distributed_arcs::process_group_type, global, decltype(own)>(
      process_group(g), global(), own);
}

}  // namespace concino::detail

namespace boost {

template<class Tag>
  requires requires(Tag tag, const concino::detail::distributed_arcs& g) { get(tag, g); }
struct property_map<concino::detail::distributed_arcs, Tag> {
  using type = decltype(get(Tag(), std::declval<const concino::detail::distributed_arcs&>()));
  using const_type = type;
};
template<class Tag>
struct property_map<const concino::detail::distributed_arcs, Tag>
    : property_map<concino::detail::distributed_arcs, Tag> {};

}  // namespace boost
