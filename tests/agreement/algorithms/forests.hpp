// Compares connected_components and spanning_tree of verts and of polys.
#pragma once

#include <agreement/algorithms/searches.hpp>

#include <concino/concepts/views.hpp>
#include <concino/graph/components.hpp>
#include <concino/graph/spanning_tree.hpp>

namespace concino::agreement {

/// Calls f(native graph, other graph, pairs) for the graphs that these algorithms use: m itself, and dual(m).
template<class B, class F>
void each_graph_alone(const B& both, F&& f) {
  using M = typename B::other_mesh;
  if constexpr (PrimalGraph<M>) f(both.native, both.other, both.verts);
  if constexpr (DualGraph<M>) f(dual(both.native), dual(both.other), both.polys);
}

struct components {
  static constexpr const char* name = "connected_components";
  template<class M> static constexpr bool runs_on = has_a_graph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    each_graph_alone(both, [](const auto& n, const auto& m, const auto& nodes) {
      const auto compare = [&](const auto& expected, const auto& found) {
        expect(expected.count == found.count, "as many components");
        for (const auto x : nodes.all) expect(expected[x] == found[nodes.to(x)], "the same component");
      };
      compare(connected_components(n), connected_components(m));
      compare(connected_components(n, {.may_enter = not_every_fifth}), connected_components(m, {.may_enter = not_every_fifth_in(nodes)}));
    });
    if constexpr (AnyMesh<typename B::other_mesh>) {
      const auto may_cross = not_every_fifth_in(both.edges);
      expect(connected_components(both.native, {.may_cross = not_every_fifth}).count ==
                 connected_components(both.other, {.may_cross = may_cross}).count,
             "as many components where edges are barred");
    }
    return true;
  }
};

struct spanning {
  static constexpr const char* name = "spanning_tree";
  template<class M> static constexpr bool runs_on = has_a_graph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    each_graph_alone(both, [&](const auto& n, const auto& m, const auto& nodes) {
      const auto length = scrambled_in(nodes);
      for (const tree_method method : {tree_method::kruskal, tree_method::prim}) {
        const auto expected = spanning_tree(n, scrambled_length, {.method = method});
        const auto found = spanning_tree(m, length, {.method = method});
        expect_close(expected.weight, found.weight, expected.weight, "the weight of the tree");
        std::vector<numbers> a, b;
        for (const auto& [x, y] : expected.arcs) a.push_back(sorted({x.raw(), y.raw()}));
        for (const auto& [x, y] : found.arcs) b.push_back(sorted({nodes.back(x).raw(), nodes.back(y).raw()}));
        expect(a == b || method == tree_method::prim, "the arcs of the tree, shortest first");
        std::sort(a.begin(), a.end());
        std::sort(b.begin(), b.end());
        expect(a == b, "the arcs of the tree");
        same_edges(both, expected, found);
      }
      if constexpr (Embedded<std::remove_cvref_t<decltype(m)>>)
        expect_close(spanning_tree(n).weight, spanning_tree(m).weight, spanning_tree(n).weight, "the weight of the tree of least length");
    });
    return true;
  }

 private:
  /// Spanning trees of verts have edges too, if the mesh has edges.
  template<class B, class A, class F>
  static void same_edges(const B& both, const A& expected, const F& found) {
    if constexpr (requires { expected.edges; found.edges; both.edges; })
      expect(sorted(raw_numbers(expected.edges)) == sorted(native_numbers(both.edges, found.edges)), "the edges of the tree");
  }
};

}  // namespace concino::agreement
