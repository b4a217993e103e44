// Adapter for Boost.Graph: compressed_sparse_row_graph and adjacency_list (verts in vecS) model PrimalGraph directly;
// any other graph of Boost does so through graph_view(g).
//
//   auto hops = cn::bfs(my_adjacency_list, 0);                                // verts are Boost's vertex_descriptors
//   auto d = cn::dijkstra(cn::graph_view(my_graph), s, [&](auto u, auto v) { return get(boost::edge_weight, g, edge(u,
//   v, g).first); });
//
// Arcs have the direction of out_edges. In a directed graph (every compressed_sparse_row_graph is one) searches and
// shortest paths follow the arcs in that direction only, as Boost's do. Algorithms on undirected edges (components,
// spanning trees, Laplacians) need the opposite of each arc in the graph, law PG3; parallel edges or loops violate PG4.
// check_laws(g) checks this. For the opposite direction, Boost's algorithms on meshes, see <concino/graph/boost.hpp>.
// Needs: Boost.Graph (Debian: libboost-dev).
#pragma once

#include <concino/adapters/detail/mapped_range.hpp>
#include <concino/concepts/primal_graph.hpp>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace concino::detail {

/// Graphs whose vertex_descriptors are the numbers 0 .. num_vertices - 1, and classes derived from them.
template<class D, class V, class E, class P, class I, class J>
std::true_type has_integer_verts(const boost::compressed_sparse_row_graph<D, V, E, P, I, J>&);
template<class O, class D, class V, class E, class P, class L>
std::true_type has_integer_verts(const boost::adjacency_list<O, boost::vecS, D, V, E, P, L>&);
template<class G> concept numbered_graph = requires(const G& g) { detail::has_integer_verts(g); };

/// Lists for which Boost has no vertex_index; even its name must not be used.
template<class O, class S, class D, class V, class E, class P, class L>
  requires(!std::same_as<S, boost::vecS> && !boost::lookup_one_property<V, boost::vertex_index_t>::found)
std::true_type has_no_vertex_index(const boost::adjacency_list<O, S, D, V, E, P, L>&);
template<class G> concept unnumbered_graph = requires(const G& g) { detail::has_no_vertex_index(g); };

template<class G> using boost_vert = typename boost::graph_traits<G>::vertex_descriptor;

template<class G> concept lists_verts = requires(const G& g) { *vertices(g).first; } && std::regular<boost_vert<G>>;
template<class G> concept lists_neighbours = requires(const G& g, boost_vert<G> v) { adjacent_vertices(v, g).first; };
template<class G> concept lists_arcs = requires(const G& g, boost_vert<G> v) { target(*out_edges(v, g).first, g); };

struct pointed_value {
  template<class Iterator>
  auto operator()(const Iterator& i) const { return *i; }
};
template<class G>
struct target_in {
  const G* g = nullptr;
  template<class Iterator>
  boost_vert<G> operator()(const Iterator& arc) const { return target(*arc, *g); }
};

template<class Vert, class Base, class At = pointed_value>
mapped_range<Vert, Base, At> make_boost_range(std::pair<Base, Base> both, At at = {}) {
  return {std::move(both.first), std::move(both.second), at};
}

/// The verts of any graph, and the targets of each.
template<class G>
struct boost_ranges {
  using vert = boost_vert<G>;
  static auto verts_of(const G& g) { return detail::make_boost_range<vert>(std::pair(vertices(g))); }
  static auto neighbours(const G& g, const vert& v) {
    if constexpr (lists_neighbours<G>) return detail::make_boost_range<vert>(std::pair(adjacent_vertices(v, g)));
    else return detail::make_boost_range<vert>(std::pair(out_edges(v, g)), target_in<G>{&g});
  }
};

}  // namespace concino::detail

namespace concino {

namespace requirement {

/// The concepts of Boost that graph_view needs: VertexListGraph, and AdjacencyGraph or IncidenceGraph.
template<class G> concept is_boost_graph =
    concino::detail::lists_verts<G> && (concino::detail::lists_neighbours<G> || concino::detail::lists_arcs<G>);
template<class P, class G> concept is_vertex_index = requires(const P& index, const concino::detail::boost_vert<G>& v) {
  { get(index, v) } -> std::convertible_to<std::size_t>;
};
template<class G>
concept has_vertex_index = is_boost_graph<G> && !concino::detail::unnumbered_graph<G> && requires(const G& g) {
  { get(boost::vertex_index, g) } -> is_vertex_index<G>;
};

}  // namespace requirement

template<detail::numbered_graph G>
struct mesh_traits<G> {
  using vert = detail::boost_vert<G>;
  static auto verts(const G& g) { return detail::boost_ranges<G>::verts_of(g); }
  static std::size_t num_verts(const G& g) { return num_vertices(g); }
  static std::size_t vert_index_bound(const G& g) { return num_vertices(g); }
  static std::size_t index_of(const G&, vert v) { return v; }
  static bool contains(const G& g, vert v) { return v < num_vertices(g); }
  static auto adj_v2v(const G& g, vert v) { return detail::boost_ranges<G>::neighbours(g, v); }
};

namespace views {

/// A graph of Boost, and the map that numbers its verts.
template<class G, class Index>
class foreign_graph {
  const G* g_;
  Index index_;
  std::size_t count_ = 0, bound_ = 0;

 public:
  foreign_graph(const G& g, Index index) : g_(&g), index_(std::move(index)) {
    for (const auto v : detail::boost_ranges<G>::verts_of(g)) {
      ++count_;
      bound_ = std::max(bound_, index_of(v) + 1);
    }
  }
  const G& base() const { return *g_; }
  std::size_t index_of(const detail::boost_vert<G>& v) const { return static_cast<std::size_t>(get(index_, v)); }
  std::size_t count() const { return count_; }
  std::size_t bound() const { return bound_; }
};

}  // namespace views

template<class G, class Index>
struct mesh_traits<views::foreign_graph<G, Index>> {
  using view = views::foreign_graph<G, Index>;
  using vert = detail::boost_vert<G>;
  static constexpr bool is_view = true;
  static auto verts(const view& g) { return detail::boost_ranges<G>::verts_of(g.base()); }
  static std::size_t num_verts(const view& g) { return g.count(); }
  static std::size_t vert_index_bound(const view& g) { return g.bound(); }
  static std::size_t index_of(const view& g, const vert& v) { return g.index_of(v); }
  static auto adj_v2v(const view& g, const vert& v) { return detail::boost_ranges<G>::neighbours(g.base(), v); }
};

/// A graph of Boost as a PrimalGraph whose verts are Boost's vertex_descriptors.
/// Needs:  VertexListGraph, and AdjacencyGraph or IncidenceGraph; vertex_index, or `index`: numbers, different for
///         different verts. g must outlive the view, so a temporary one is refused; after verts were added or removed,
///         a new view is needed.
/// Result: a view. It satisfies law PG3 if g is undirected or has the opposite of each arc, PG4 if it has no loops and
///         no parallel edges.
/// Cost:   O(V) to count the verts: a filtered_graph has fewer than the numbers it uses. Nothing is copied.
/// Errors: none of its own.
template<class G>
  requires requirement::has_vertex_index<G>
auto graph_view(const G& g) {
  using index_map = std::remove_cvref_t<decltype(get(boost::vertex_index, g))>;
  return views::foreign_graph<G, index_map>(g, get(boost::vertex_index, g));
}
template<class G, class Index>
  requires requirement::is_boost_graph<G> && requirement::is_vertex_index<Index, G>
auto graph_view(const G& g, Index index) {
  return views::foreign_graph<G, Index>(g, std::move(index));
}
template<class G> requires requirement::is_boost_graph<G> void graph_view(const G&& g) = delete;  // give the graph a name: auto g = ...;
template<class G, class Index> requires requirement::is_boost_graph<G> void graph_view(const G&& g, Index index) = delete;  // give the graph a name: auto g = ...;

static_assert(PrimalGraph<boost::compressed_sparse_row_graph<>> &&
              PrimalGraph<boost::compressed_sparse_row_graph<boost::bidirectionalS>>);
static_assert(PrimalGraph<boost::adjacency_list<>> &&
              PrimalGraph<boost::adjacency_list<boost::setS, boost::vecS, boost::undirectedS>>);

}  // namespace concino
