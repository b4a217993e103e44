// min_cut: the arcs of the smallest total capacity that separate some verts, or polys, from others.
// Not part of <concino/graph.hpp>: without concino::compiled it includes the maximum flow of Boost.Graph, which takes
// as long to compile as all of that.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/graph/detail/cuts/flow.hpp>
#include <concino/graph/detail/for_each.hpp>
#include <concino/graph/shortest_path.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace concino {

/// Node is a vert (primal graph) or a poly (dual graph).
template<class M, class Node>
struct graph_cut {
  element_map<M, Node, bool> on_source_side;  // whether each node is on the side of the sources
  std::vector<std::pair<Node, Node>> arcs;    // those from the side of the sources to that of the sinks
  double capacity = 0;                        // their sum: the largest flow from the sources to the sinks
  int scale_exponent = 0;                     // minimal for capacities rounded to multiples of 2^-scale_exponent
};

namespace detail {

template<class G, class C>
double capacity_of_arc(const G& g, const C& capacity, const typename G::node& v, const typename G::node& w) {
  const auto c = static_cast<double>(capacity(v, w));
  if (!(c >= 0))
    core::throw_joined<invalid_mesh>({"min_cut: the capacity from ", name_of(g, v), " to ", name_of(g, w), " is ",
                                      c < 0 ? core::number_text(c) : std::string("not a number"),
                                      "; capacities must be 0 or more; +inf keeps two nodes together"});
  return c;
}

/// The arcs between two neighbours, with the capacities that the caller returned.
template<class Node>
struct capacity_pair {
  Node a, b;
  double forth, back;
};

/// The pairs of neighbours, each once.
template<class G, class C>
std::vector<capacity_pair<typename G::node>> read_capacities(const G& g, const C& capacity) {
  using node = typename G::node;
  std::vector<capacity_pair<node>> pairs;
  for (const node v : g.nodes())
    detail::for_each(g.neighbours(v), [&](const node& w) {
      if (g.index(v) >= g.index(w)) return;
      const double forth = capacity_of_arc(g, capacity, v, w), back = capacity_of_arc(g, capacity, w, v);
      if (forth > 0 || back > 0) pairs.push_back({v, w, forth, back});
    });
  return pairs;
}

template<class Node>
integer_scale scale_of_capacities(const std::vector<capacity_pair<Node>>& pairs) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto finite = [](double c) { return c < infinity ? c : 0; };
  integer_scale::sum sum;
  for (const auto& p : pairs) sum.raise_largest(std::max(finite(p.forth), finite(p.back)));
  for (const auto& p : pairs) {
    sum.add(finite(p.forth));
    sum.add(finite(p.back));
  }
  return sum.scale();
}

/// Twice the sum of all capacities at most, so that no minimum cut has an arc of this capacity.
inline constexpr std::int64_t unlimited_capacity = std::int64_t{1} << 61;

/// Marks the nodes of sources and sinks in the terminals.
template<class G, class S>
void set_terminals(const G& g, const S& nodes, const char* role, std::int64_t capacity,
                   std::vector<std::int64_t>& terminals) {
  for_each_source(
      g, nodes, "min_cut",
      [&](const typename G::node& x) {
        std::int64_t& t = terminals[g.index(x)];
        if (t != 0 && t != capacity)
          core::throw_joined<invalid_argument>(
              {"min_cut: ", name_of(g, x), " is a source and a sink; no cut separates it from itself"});
        t = capacity;
      },
      role);
}

template<class G, class S, class T, class C>
auto find_min_cut(const G& g, const S& sources, const T& sinks, const C& capacity) {
  using node = typename G::node;
  flow_network network{std::vector<std::int64_t>(g.bound()), {}};
  set_terminals(g, sources, "source", unlimited_capacity, network.terminals);
  set_terminals(g, sinks, "sink", -unlimited_capacity, network.terminals);
  const auto pairs = read_capacities(g, capacity);
  const integer_scale scale = scale_of_capacities(pairs);
  const auto integer = [&](double c) {
    return c < std::numeric_limits<double>::infinity() ? scale(c) : unlimited_capacity;
  };
  network.edges.reserve(pairs.size());
  for (const auto& p : pairs)
    network.edges.push_back({static_cast<std::uint32_t>(g.index(p.a)), static_cast<std::uint32_t>(g.index(p.b)),
                             integer(p.forth), integer(p.back)});
  if (const std::size_t i = end_of_unlimited_path(network, unlimited_capacity); i < g.bound())
    core::throw_joined<invalid_argument>({"min_cut: arcs of infinite capacity lead from a source to the sink ",
                                          G::element_name, " ", i,
                                          ", so that every cut has infinite capacity; make one of them finite"});
  const std::vector<unsigned char> side = source_side(network, "min_cut");
  graph_cut<typename G::mesh, node> cut{make_node_map<bool>(g, false), {}, 0, scale.exponent};
  for (const node v : g.nodes()) cut.on_source_side[v] = side[g.index(v)];
  for (const auto& [a, b, forth, back] : pairs) {
    if (side[g.index(a)] == side[g.index(b)]) continue;
    const bool from_a = side[g.index(a)];
    if ((from_a ? forth : back) == 0) continue;
    cut.arcs.emplace_back(from_a ? a : b, from_a ? b : a);
    cut.capacity += from_a ? forth : back;
  }
  return cut;
}

}  // namespace detail

namespace requirement {

/// A function that returns the capacity of the arc from one node to another.
template<class C, class N> concept is_capacity = is_length<C, N>;

}  // namespace requirement

/// The minimum cut between sources and sinks, verts or polys. It divides the nodes so that no source is with a sink,
/// and the arcs from the sources' part to the other have the smallest sum of capacities.
/// Needs:  PrimalGraph M for verts, DualGraph M for polys; capacity(from, to) >= 0, which may differ from
///         capacity(to, from); +inf: never cut.
/// Result: a graph_cut. Of several minimum cuts, the one with the fewest nodes on the sources' side. It is exact if the
///         capacities are integers or other multiples of 2^-scale_exponent. Else each is rounded to one, and the sum
///         exceeds the smallest by at most as many of them as the network has arcs: about 2^-60 of the sum of all
///         capacities for each arc.
/// Cost:   O(V^2 E) per augmenting path at worst, on meshes about proportional to E; O(V + E) memory.
/// Errors: invalid_mesh if a source or sink is not an element of m, or a capacity is negative or not a number.
///         invalid_argument if there is no source or no sink, if a node is both, or if arcs of infinite capacity lead
///         from one to the other.
/// Source: Boykov, Kolmogorov 2004, by Boost.Graph; paper section 2.2.
template<class M, class S, class T, class C>
  requires requirement::is_lvalue_or_view<M> && requirement::is_target<M, S, T> &&
      requirement::is_capacity<C, detail::node_of<M, S>>
auto min_cut(M&& m, const S& sources, const T& sinks, const C& capacity) {
  return detail::find_min_cut(detail::graph_of<M, S>{m}, sources, sinks, capacity);
}

template<class M, class S, class C>
  requires requirement::is_lvalue_or_view<M> && requirement::is_source<M, S> &&
      requirement::is_capacity<C, detail::node_of<M, S>>
auto min_cut(M&& m, std::initializer_list<S> sources, std::initializer_list<S> sinks, const C& capacity) {
  return detail::find_min_cut(detail::graph_of<M, S>{m}, sources, sinks, capacity);
}

// What to write instead of calls that cannot compile.
template<class... T> void min_cut(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void min_cut(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void min_cut(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino
