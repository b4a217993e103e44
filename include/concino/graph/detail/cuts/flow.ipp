// Maximum flow by Boost.Graph, on a graph of arcs in flat arrays; see flow.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/graph/detail/cuts/flow.hpp>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <limits>
#include <utility>

// A namespace of its own: here edges, source and target are functions of Boost's graph concepts.
namespace concino::detail::flow_graphs {

/// The arcs of a network, by source. The terminals are the last two nodes; arcs are numbers.
struct flow_graph {
  std::vector<std::uint32_t> first, target, reverse;  // by node: its first arc; by arc: its target, the opposite arc
  std::vector<std::int64_t> residual;                 // by arc
};
using number = std::uint32_t;
using numbers = std::pair<boost::counting_iterator<number>, boost::counting_iterator<number>>;

inline numbers from_to(number first, number last) {
  return {boost::counting_iterator<number>(first), boost::counting_iterator<number>(last)};
}
inline number num_vertices(const flow_graph& g) { return static_cast<number>(g.first.size() - 1); }
inline number num_edges(const flow_graph& g) { return static_cast<number>(g.target.size()); }
inline numbers vertices(const flow_graph& g) { return from_to(0, num_vertices(g)); }
inline numbers edges(const flow_graph& g) { return from_to(0, num_edges(g)); }
inline numbers out_edges(number v, const flow_graph& g) { return from_to(g.first[v], g.first[v + 1]); }
inline number out_degree(number v, const flow_graph& g) { return g.first[v + 1] - g.first[v]; }
inline number target(number arc, const flow_graph& g) { return g.target[arc]; }
inline number source(number arc, const flow_graph& g) { return g.target[g.reverse[arc]]; }

/// The graph of a network, or an error if its arcs cannot be numbered.
CONCINO_INLINE flow_graph graph_of_network(const flow_network& network, const char* caller) {
  const std::size_t nodes = network.terminals.size();
  std::vector<std::size_t> degree(nodes + 2);
  std::size_t arcs = 2 * network.edges.size();
  for (const flow_edge& e : network.edges) {
    ++degree[e.a];
    ++degree[e.b];
  }
  for (std::size_t i = 0; i < nodes; ++i) {
    if (network.terminals[i] == 0) continue;
    ++degree[i];
    ++degree[network.terminals[i] > 0 ? nodes : nodes + 1];
    arcs += 2;
  }
  if (arcs >= std::numeric_limits<number>::max())
    core::throw_joined<unsupported>({caller, ": the network has ", arcs, " arcs; at most 2^32 - 2 are possible"});
  flow_graph g;
  g.first.resize(nodes + 3);
  for (std::size_t i = 0; i < nodes + 2; ++i) g.first[i + 1] = static_cast<number>(g.first[i] + degree[i]);
  g.target.resize(arcs);
  g.reverse.resize(arcs);
  g.residual.resize(arcs);
  std::vector<number> next(g.first.begin(), g.first.end() - 1);
  const auto add = [&](number a, number b, std::int64_t forth, std::int64_t back) {
    const number arc = next[a]++, opposite = next[b]++;
    g.target[arc] = b;
    g.target[opposite] = a;
    g.reverse[arc] = opposite;
    g.reverse[opposite] = arc;
    g.residual[arc] = forth;
    g.residual[opposite] = back;
  };
  // Those of the terminals come first, where searches for the sink begin.
  const auto from = static_cast<number>(nodes), to = static_cast<number>(nodes + 1);
  for (number i = 0; i < from; ++i) {
    const std::int64_t t = network.terminals[i];
    if (t > 0) add(from, i, t, 0);
    if (t < 0) add(i, to, -t, 0);
  }
  for (const flow_edge& e : network.edges) add(e.a, e.b, e.forth, e.back);
  return g;
}

}  // namespace concino::detail::flow_graphs

template<>
struct boost::graph_traits<concino::detail::flow_graphs::flow_graph> {
  using vertex_descriptor = std::uint32_t;
  using edge_descriptor = std::uint32_t;
  using directed_category = directed_tag;
  using edge_parallel_category = allow_parallel_edge_tag;
  struct traversal_category : vertex_list_graph_tag, edge_list_graph_tag, incidence_graph_tag {};
  using vertex_iterator = counting_iterator<std::uint32_t>;
  using edge_iterator = counting_iterator<std::uint32_t>;
  using out_edge_iterator = counting_iterator<std::uint32_t>;
  using vertices_size_type = std::uint32_t;
  using edges_size_type = std::uint32_t;
  using degree_size_type = std::uint32_t;

  static vertex_descriptor null_vertex() { return std::numeric_limits<std::uint32_t>::max(); }
};

namespace concino::detail {

CONCINO_INLINE std::vector<unsigned char> source_side(const flow_network& network, const char* caller) {
  const std::size_t nodes = network.terminals.size();
  flow_graphs::flow_graph g = flow_graphs::graph_of_network(network, caller);
  std::vector<boost::default_color_type> color(nodes + 2);
  std::vector<std::uint32_t> predecessor(nodes + 2);
  std::vector<std::uint32_t> distance(nodes + 2);
  const auto from = static_cast<std::uint32_t>(nodes);
  // Types of Boost, not pointers: where other headers of Boost come first, those hide the functions for pointers.
  const boost::typed_identity_property_map<std::uint32_t> index;
  const auto map_of = [&](auto& values) { return boost::make_iterator_property_map(values.data(), index); };
  // The capacities are their own residuals: the algorithm first copies the one to the other.
  boost::boykov_kolmogorov_max_flow(g, map_of(g.residual), map_of(g.residual), map_of(g.reverse), map_of(predecessor),
                                    map_of(color), map_of(distance), index, from, from + 1);
  std::vector<unsigned char> on_source_side(nodes);
  for (std::size_t i = 0; i < nodes; ++i) on_source_side[i] = color[i] == boost::black_color;
  return on_source_side;
}

CONCINO_INLINE std::size_t end_of_unlimited_path(const flow_network& network, std::int64_t capacity) {
  const std::size_t nodes = network.terminals.size();
  std::vector<std::size_t> first(nodes + 1);
  for (const flow_edge& e : network.edges) {
    first[e.a + 1] += e.forth >= capacity;
    first[e.b + 1] += e.back >= capacity;
  }
  for (std::size_t i = 0; i < nodes; ++i) first[i + 1] += first[i];
  std::vector<std::uint32_t> targets(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const flow_edge& e : network.edges) {
    if (e.forth >= capacity) targets[next[e.a]++] = e.b;
    if (e.back >= capacity) targets[next[e.b]++] = e.a;
  }
  std::vector<std::size_t> open;
  std::vector<unsigned char> is_reached(nodes);
  const auto enter = [&](std::size_t i) {
    if (!std::exchange(is_reached[i], 1)) open.push_back(i);
  };
  for (std::size_t i = 0; i < nodes; ++i)
    if (network.terminals[i] >= capacity) enter(i);
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    if (network.terminals[i] <= -capacity) return i;
    for (std::size_t k = first[i]; k < first[i + 1]; ++k) enter(targets[k]);
  }
  return nodes;
}

CONCINO_INLINE integer_scale integer_scale::sum::scale() const {
  if (!(total_ > 0)) return {};
  // total_ * largest_ < 2^(e + f)
  int e = 0, f = 0;
  std::frexp(total_, &e);
  std::frexp(largest_, &f);
  return {60 - e - f};
}

CONCINO_INLINE std::int64_t integer_scale::operator()(double value) const {
  return std::llround(std::ldexp(value, exponent));
}

CONCINO_INLINE double integer_scale::back(std::int64_t integer) const {
  return std::ldexp(static_cast<double>(integer), -exponent);
}

}  // namespace concino::detail
