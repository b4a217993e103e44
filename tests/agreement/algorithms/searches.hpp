// Compares bfs, dijkstra, shortest_path and grow_regions from verts and from polys.
#pragma once

#include <agreement/matched.hpp>

#include <concino/graph/bfs.hpp>
#include <concino/graph/dijkstra.hpp>
#include <concino/graph/grow_regions.hpp>
#include <concino/graph/shortest_path.hpp>

namespace concino::agreement {

template<class M> inline constexpr bool has_a_graph = PrimalGraph<M> || DualGraph<M>;

/// Whether an element may be entered; the same for elements of the other mesh.
inline constexpr auto not_every_fifth = [](auto x) { return x.raw() % 5 != 3; };
template<class P>
auto not_every_fifth_in(const P& pairs) {
  return [&pairs](const auto& x) { return not_every_fifth(pairs.back(x)); };
}

/// The elements between two nodes: edges, or faces between polys of a volume.
template<class B, class P>
const auto& crossings_of(const B& both, const P&) {
  if constexpr (requires { both.faces; } && std::same_as<typename P::id, poly_id>) return both.faces;
  else return both.edges;
}

struct breadth_first {
  static constexpr const char* name = "bfs";
  template<class M> static constexpr bool runs_on = has_a_graph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    bool any = false;
    each_graph(both, [&](const auto& nodes) {
      if (nodes.empty()) return;
      any = true;
      const auto compare = [&](const auto& expected, const auto& found) {
        for (const auto x : nodes.all) expect(expected[x] == found[nodes.to(x)], "as many steps");
      };
      const auto a = nodes.first(), b = nodes.all[nodes.all.size() / 2], c = nodes.last();
      compare(bfs(both.native, a), bfs(both.other, nodes.to(a)));
      compare(bfs(both.native, {a, c}), bfs(both.other, {nodes.to(a), nodes.to(c)}));
      const auto may_enter = not_every_fifth_in(nodes);
      compare(bfs(both.native, b, {.may_enter = not_every_fifth, .max_hops = 3}), bfs(both.other, nodes.to(b), {.may_enter = may_enter, .max_hops = 3}));
      compare(bfs(both.native, a, {.targets = {b}}), bfs(both.other, nodes.to(a), {.targets = {nodes.to(b)}}));
      if constexpr (AnyMesh<typename B::other_mesh>) {
        const auto may_cross = not_every_fifth_in(crossings_of(both, nodes));
        compare(bfs(both.native, a, {.may_cross = not_every_fifth}), bfs(both.other, nodes.to(a), {.may_cross = may_cross}));
      }
    });
    return any;
  }
};

struct by_length {
  static constexpr const char* name = "dijkstra";
  template<class M> static constexpr bool runs_on = has_a_graph<M>;

  template<class B, class In>
  static bool check(const B& both, const In& in) {
    using M = typename B::other_mesh;
    bool any = false;
    each_graph(both, [&](const auto& nodes) {
      if (nodes.empty()) return;
      any = true;
      const auto compare = [&](const auto& expected, const auto& found) {
        const double largest = largest_of(nodes.all, [&](const auto x) { return expected[x]; });
        for (const auto x : nodes.all) expect_close(expected[x], found[nodes.to(x)], largest, "as far");
      };
      const auto same_path = [&](const auto& expected, const auto& found) {
        expect(raw_numbers(expected) == native_numbers(nodes, found), "the same way");
      };
      const auto length = scrambled_in(nodes);
      const auto a = nodes.first(), b = nodes.all[nodes.all.size() / 2], c = nodes.last();
      compare(dijkstra(both.native, a, scrambled_length), dijkstra(both.other, nodes.to(a), length));
      compare(dijkstra(both.native, {a, c}, scrambled_length, {.may_enter = not_every_fifth, .max_distance = 4}),
              dijkstra(both.other, {nodes.to(a), nodes.to(c)}, length, {.may_enter = not_every_fifth_in(nodes), .max_distance = 4}));
      same_path(shortest_path(both.native, a, b, scrambled_length), shortest_path(both.other, nodes.to(a), nodes.to(b), length));
      using native_node = typename std::remove_cvref_t<decltype(nodes)>::id;
      if constexpr (Embedded<M> && (std::same_as<native_node, vert_id> || AnyMesh<M>)) {
        compare(dijkstra(both.native, b), dijkstra(both.other, nodes.to(b)));
        if (in.manifold) same_path(shortest_path(both.native, b, c), shortest_path(both.other, nodes.to(b), nodes.to(c)));
      }
    });
    return any;
  }
};

struct region_growing {
  static constexpr const char* name = "grow_regions";
  template<class M> static constexpr bool runs_on = has_a_graph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    bool any = false;
    each_graph(both, [&](const auto& nodes) {
      if (nodes.empty()) return;
      any = true;
      const auto a = nodes.first(), b = nodes.all[nodes.all.size() / 2], c = nodes.last();
      const auto compare = [&](const auto& expected, const auto& found) {
        for (const auto x : nodes.all) expect(expected[x] == found[nodes.to(x)], "the same region");
      };
      compare(grow_regions(both.native, {a, b, c}, scrambled_length), grow_regions(both.other, {nodes.to(a), nodes.to(b), nodes.to(c)}, scrambled_in(nodes)));
      const auto far = [](double x) { return x < 1.8; };
      compare(grow_regions(both.native, {a, b, c}, [&](auto x, auto y) { return far(scrambled_length(x, y)); }),
              grow_regions(both.other, {nodes.to(a), nodes.to(b), nodes.to(c)}, [&](const auto& x, const auto& y) { return far(scrambled_in(nodes)(x, y)); }));
    });
    return any;
  }
};

}  // namespace concino::agreement
