// Boost.Graph on any mesh: primal(m) and dual(m) model its graph concepts, and boost_map(map) is a Boost property map.
// Not part of <concino/graph.hpp>: it takes long to compile.
//
//   auto label = cn::make_vert_map<int>(m);
//   int k = boost::connected_components(cn::primal(m), cn::boost_map(label));                       // label[v]
//   boost::dijkstra_shortest_paths(cn::dual(m), p, boost::distance_map(cn::boost_map(distance)));   // Euclidean
//   lengths by default
//
// The concepts of Boost on these graphs:
//   - They are undirected, without parallel edges, and model VertexListGraph, EdgeListGraph, AdjacencyGraph,
//     IncidenceGraph and BidirectionalGraph. Vertices are the verts or polys of the mesh; edges are pairs of them,
//     computed during iteration. Nothing is copied.
//   - num_vertices(g) is the index bound: Boost uses it as the size of arrays that it indexes by vertex_index, and
//     removed elements leave gaps. vertices(g) has only the existing elements, so gaps are not vertices. But algorithms
//     that divide by num_vertices(g) (relative_betweenness_centrality) or expect that many vertices (topological
//     orders, planarity) need a mesh without gaps.
//   - get(boost::vertex_index, g), get(boost::edge_weight, g) (Euclidean distance of verts, or of the means of polys'
//     verts) and get(boost::edge_index, g) are property maps, which Boost uses by default. The last one numbers all
//     edges, in O(V + E).
//   - directed(g) has two arcs for every edge, and get(boost::edge_reverse, g): for flows. (push_relabel_max_flow of
//     Boost needs arcs whose opposite has no capacity; boykov_kolmogorov_max_flow and edmonds_karp_max_flow accept
//     any.)
//   - An array of results can be used instead of a map: make_iterator_property_map(array.begin(),
//     get(boost::vertex_index, g)).
//   - Argument-dependent lookup finds these functions, in algorithms and in your own code. But after `using namespace
//     concino`, edges and num_edges are the verbs of meshes; write concino::views::edges(g) and
//     concino::views::num_edges(g) there.
#pragma once

#include <concino/graph/detail/boost_functions.hpp>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>

#include <limits>
#include <memory>
#include <type_traits>
#include <utility>

namespace concino {

/// A concino map as a property map of Boost: boost_map(map), or boost_map<Key>(map) if the map has no key_type.
/// Needs:  map[x] for each x of type Key. Maps that return proxies have a value_type. A map that is an lvalue must
///         outlive the result.
/// Result: lvalue, read-write or readable, as map[x] is. Copies of it share one map.      Cost: none.      Errors: none
///         of its own.
template<class Key, class P>
  requires ReadableMap<P, Key>
auto boost_map(P&& map) {
  using map_type = std::remove_reference_t<P>;
  if constexpr (std::is_lvalue_reference_v<P>) return detail::map_of_map<map_type, Key, map_type*>(&map);
  else
    return detail::map_of_map<map_type, Key, std::shared_ptr<map_type>>(
        std::make_shared<map_type>(std::forward<P>(map)));
}
template<class P>
  requires ReadableMap<P, typename std::remove_cvref_t<P>::key_type>
auto boost_map(P&& map) { return concino::boost_map<typename std::remove_cvref_t<P>::key_type>(std::forward<P>(map)); }

/// Lengths, capacities or other values of edges from a callable, which is called on each access.
/// Needs:  g: primal(m), dual(m) or directed(...); f(source, target) is a value, equal to f(target, source) unless g is
///         directed.
/// Result: a readable property map of g's edges.      Cost: none.      Errors: those of f.
template<detail::boost_view G, class F>
  requires std::is_invocable_v<const F&, detail::node_in<G>, detail::node_in<G>>
auto boost_weights(const G&, F f) { return detail::map_of_ends<detail::edge_in<G>, F>(std::move(f)); }

/// A value per edge of primal(m) or dual(m), or per arc of directed(...): `init`, or what init(source, target) returns.
/// Needs:  g: primal(m), dual(m) or directed(...); init, or what it returns, converts to T.
/// Result: an lvalue property map, whose copies share their values.      Cost: O(V + E) time and memory.
/// Errors: invalid_mesh if some w is a neighbour of v, but not v of w; those of init.
template<class T, detail::boost_view G, class I = T>
auto boost_edge_map(const G& g, const I& init = I()) {
  if constexpr (std::is_invocable_v<const I&, detail::node_in<G>, detail::node_in<G>>) {
    detail::edge_value_map<G, T> values(get(boost::edge_index, g), T());
    for (auto [e, last] = views::edges(g); e != last; ++e) values[*e] = static_cast<T>(init((*e).source, (*e).target));
    return values;
  } else {
    return detail::edge_value_map<G, T>(get(boost::edge_index, g), static_cast<T>(init));
  }
}

/// The graph with two opposite arcs for every edge, as flow algorithms need.
/// Needs:  g: primal(m) or dual(m); the mesh must outlive the result, as for g; descriptors whose default value is no
///         element, as all of this library.
/// Result: directed, models what g models; edges(d) are all arcs, get(boost::edge_reverse, d)[a] is the opposite arc of
///         a.
/// Cost:   O(V + E) time, 8 bytes per node and arc, for the arcs' numbers.
/// Errors: invalid_mesh if some w is a neighbour of v, but not v of w; unsupported if a default descriptor is an
///         element.
template<class G>
  requires detail::is_undirected<G>
auto directed(const G& g) {
  const auto base = detail::base_graph(g);
  if constexpr (!std::is_arithmetic_v<detail::node_in<G>>) {
    for (const detail::node_in<G> v : base.nodes())
      if (v == detail::node_in<G>())
        throw unsupported(
            "directed: Boost's flow algorithms use the default descriptor as null vertex, but in this mesh it names an element; "
            "change the descriptor type so that its default value names none");
  }
  return views::directed_view<G>(g);
}

}  // namespace concino

namespace boost {

template<concino::detail::boost_view G>
struct graph_traits<G> {
  using vertex_descriptor = concino::detail::node_in<G>;
  using edge_descriptor = concino::detail::edge_in<G>;
  using directed_category = std::conditional_t<concino::detail::is_directed<G>, bidirectional_tag, undirected_tag>;
  using edge_parallel_category = disallow_parallel_edge_tag;
  struct traversal_category : bidirectional_graph_tag,
                              adjacency_graph_tag,
                              vertex_list_graph_tag,
                              edge_list_graph_tag {};
  using vertex_iterator = concino::detail::node_iterator<vertex_descriptor, concino::detail::nodes_in<G>>;
  using adjacency_iterator = concino::detail::node_iterator<vertex_descriptor, concino::detail::ring_in<G>>;
  using out_edge_iterator = concino::detail::incidence_iterator<edge_descriptor, concino::detail::ring_in<G>, true>;
  using in_edge_iterator = concino::detail::incidence_iterator<edge_descriptor, concino::detail::ring_in<G>, false>;
  using edge_iterator = concino::detail::edge_iterator<G>;
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;

  /// The value that flows and matchings use for "no vertex".
  static vertex_descriptor null_vertex() {
    if constexpr (std::is_arithmetic_v<vertex_descriptor>) return std::numeric_limits<vertex_descriptor>::max();
    else return vertex_descriptor();
  }
};
template<concino::detail::boost_view G> struct graph_traits<const G> : graph_traits<G> {};

template<class G, class Tag>
  requires concino::detail::boost_view<std::remove_const_t<G>> && requires(Tag tag, const G& g) {
    concino::views::get(tag, g);
  }
struct property_map<G, Tag> {
  using type = decltype(concino::views::get(Tag(), std::declval<const G&>()));
  using const_type = type;
};

}  // namespace boost
