// Compares algorithms of Boost.Graph on primal(m) and dual(m).
#pragma once

#include <agreement/algorithms/forests.hpp>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <concino/graph/boost.hpp>

namespace concino::agreement {

struct boost_algorithms {
  static constexpr const char* name = "boost";
  template<class M> static constexpr bool runs_on = has_a_graph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    using M = typename B::other_mesh;
    bool any = false;
    if constexpr (PrimalGraph<M>) any = compare(primal(both.native), primal(both.other), both.verts);
    if constexpr (DualGraph<M>) any = compare(dual(both.native), dual(both.other), both.polys) || any;
    return any;
  }

 private:
  template<class T, class G>
  static auto map_into(std::vector<T>& values, const G& g, std::size_t bound) {
    values.resize(bound);
    return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, g));
  }

  template<class N, class G, class P>
  static bool compare(const N& n, const G& g, const P& nodes) {
    if (nodes.empty()) return false;
    std::size_t bound = 0;
    for (const auto x : nodes.all) bound = std::max(bound, std::size_t(index_of(g, nodes.to(x))) + 1);
    std::vector<double> far;
    const auto infinity = std::numeric_limits<double>::infinity();
    const auto weights = boost_weights(g, scrambled_in(nodes));
    boost::dijkstra_shortest_paths(g, nodes.to(nodes.first()), boost::distance_map(map_into(far, g, bound)).weight_map(weights).distance_inf(infinity));
    const auto expected = dijkstra(n, nodes.first(), scrambled_length);
    const double largest = largest_of(nodes.all, [&](const auto x) { return expected[x]; });
    for (const auto x : nodes.all) expect_close(expected[x], far[index_of(g, nodes.to(x))], largest, "as far, says Boost");
    std::vector<int> label;
    const int count = boost::connected_components(g, map_into(label, g, bound));
    const auto parts = connected_components(n);
    expect(count == parts.count, "as many components, says Boost");
    for (const auto x : nodes.all) expect(label[index_of(g, nodes.to(x))] == parts[x], "the same component, says Boost");
    return true;
  }
};

}  // namespace concino::agreement
