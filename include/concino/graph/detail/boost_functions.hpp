// The functions of Boost.Graph for views: vertices(g), out_edges(v, g), get(boost::vertex_index, g) ...
#pragma once

#include <concino/graph/detail/boost_maps.hpp>

#include <boost/graph/properties.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace concino::views {

template<class G>
class directed_view : public view_base<G> {
  std::shared_ptr<const detail::edge_numbers<true>> numbers_;

 public:
  explicit directed_view(const G& g)
      : view_base<G>(g), numbers_(std::make_shared<const detail::edge_numbers<true>>(detail::base_graph(g))) {}
  const auto& numbers() const { return numbers_; }
};

// Boost's algorithms call these unqualified, and find them by argument-dependent lookup, because the views are in this
// namespace.
template<detail::boost_view G>
auto vertices(const G& g) {
  using iterator = detail::node_iterator<detail::node_in<G>, detail::nodes_in<G>>;
  return iterator::begin_and_end([&]() -> decltype(auto) { return detail::base_graph(g).nodes(); });
}
template<detail::boost_view G>
std::size_t num_vertices(const G& g) { return detail::base_graph(g).bound(); }

template<detail::boost_view G>
auto adjacent_vertices(const detail::node_in<G>& v, const G& g) {
  using iterator = detail::node_iterator<detail::node_in<G>, detail::ring_in<G>>;
  return iterator::begin_and_end([&]() -> decltype(auto) { return detail::base_graph(g).neighbours(v); });
}
template<detail::boost_view G>
auto out_edges(const detail::node_in<G>& v, const G& g) {
  using iterator = detail::incidence_iterator<detail::edge_in<G>, detail::ring_in<G>, true>;
  return iterator::begin_and_end(v, [&]() -> decltype(auto) { return detail::base_graph(g).neighbours(v); });
}
template<detail::boost_view G>
auto in_edges(const detail::node_in<G>& v, const G& g) {
  using iterator = detail::incidence_iterator<detail::edge_in<G>, detail::ring_in<G>, false>;
  return iterator::begin_and_end(v, [&]() -> decltype(auto) { return detail::base_graph(g).neighbours(v); });
}
template<detail::boost_view G>
auto edges(const G& g) {
  const auto [first, last] = vertices(g);
  using iterator = detail::edge_iterator<G>;
  return std::pair(iterator(g, first, last), iterator(g, last, last));
}
template<detail::boost_view G>
std::size_t out_degree(const detail::node_in<G>& v, const G& g) {
  std::size_t n = 0;
  for ([[maybe_unused]] const detail::node_in<G> w : detail::base_graph(g).neighbours(v)) ++n;
  return n;
}
template<detail::boost_view G>
std::size_t in_degree(const detail::node_in<G>& v, const G& g) { return out_degree(v, g); }
template<detail::boost_view G>
std::size_t degree(const detail::node_in<G>& v, const G& g) {
  return out_degree(v, g) * (detail::is_directed<G> ? 2 : 1);
}
template<detail::boost_view G>
std::size_t num_edges(const G& g) {
  if constexpr (detail::is_directed<G>) return g.numbers()->size();
  std::size_t arcs = 0;
  for (const detail::node_in<G> v : detail::base_graph(g).nodes()) arcs += out_degree(v, g);
  return arcs / 2;
}
template<detail::boost_view G>
detail::node_in<G> source(const detail::edge_in<G>& e, const G&) { return e.source; }
template<detail::boost_view G>
detail::node_in<G> target(const detail::edge_in<G>& e, const G&) { return e.target; }
/// The edge from u to v and whether there is one, in O(edges at u).
template<detail::boost_view G>
std::pair<detail::edge_in<G>, bool> edge(const detail::node_in<G>& u, const detail::node_in<G>& v, const G& g) {
  for (auto [e, last] = out_edges(u, g); e != last; ++e)
    if (const auto found = *e; found.target == v) return {found, true};
  return {};
}

template<detail::boost_view G>
auto get(boost::vertex_index_t, const G& g) {
  if constexpr (detail::is_directed<G>) return detail::node_index_map<detail::undirected_form<G>>(g.base());
  else return detail::node_index_map<G>(g);
}
template<detail::boost_view G>
std::size_t get(boost::vertex_index_t, const G& g, const detail::node_in<G>& v) {
  return detail::base_graph(g).index(v);
}
template<detail::boost_view G>
auto get(boost::edge_index_t, const G& g) {
  if constexpr (detail::is_directed<G>) return detail::edge_index_map<G>(g.base(), g.numbers());
  else return detail::edge_index_map<G>(g, std::make_shared<const detail::edge_numbers<false>>(detail::base_graph(g)));
}
template<detail::boost_view G>
  requires detail::measured<G>
auto get(boost::edge_weight_t, const G& g) { return detail::distance_map<G>(detail::distances(g)); }
template<class G>
auto get(boost::edge_reverse_t, const directed_view<G>&) {
  return detail::opposite_map<detail::edge_in<directed_view<G>>>();
}
/// The value at one key; for many values, get the map once.
template<detail::boost_view G, class Tag>
  requires(!std::is_same_v<Tag, boost::vertex_index_t>) && requires(Tag tag, const G& g) { get(tag, g); }
auto get(Tag tag, const G& g, const detail::edge_in<G>& e) { return get(tag, g)[e]; }

}  // namespace concino::views
