#include <concino/graph/bfs.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/boost_graph.hpp>
#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

struct ring { std::size_t n; };

template<class M, class S = vert_id> concept searchable = requires(const S& s) { bfs(std::declval<M>(), s); };
template<class M> concept has_forest = requires { bfs_forest(std::declval<M>()); };
constexpr auto one = [](auto, auto) { return 1.0; };

}  // namespace

template<>
struct concino::mesh_traits<ring> {
  using vert = vert_id;
  static std::size_t num_verts(const ring& r) { return r.n; }
  static std::size_t vert_index_bound(const ring& r) { return r.n; }
  static std::size_t index_of(const ring&, vert_id v) { return v.raw(); }
  static id_range<vert_id> verts(const ring& r) { return id_range<vert_id>(r.n); }
  static std::array<vert_id, 2> adj_v2v(const ring& r, vert_id v) { return {vert_id{(v.raw() + 1) % r.n}, vert_id{(v.raw() + r.n - 1) % r.n}}; }
};

TEST_CASE("bfs: hop counts on a ring are right, from one source and several") {
  const ring r{7};
  const auto hops = bfs(r, vert_id{0});
  const int expected[] = {0, 1, 2, 3, 3, 2, 1};
  for (unsigned i = 0; i < 7; ++i) CHECK(hops[vert_id{i}] == expected[i]);

  CHECK(bfs(r, {vert_id{0}, vert_id{3}})[vert_id{2}] == 1);
  CHECK(bfs(r, std::vector{vert_id{5}, vert_id{5}})[vert_id{1}] == 3);
  CHECK_THROWS_WITH_AS(bfs(r, std::vector<vert_id>{}), "bfs: there is no source; give at least one vert", invalid_argument);
  CHECK_THROWS_WITH_AS(bfs(r, std::vector<vert_id>{}, {.max_hops = 3}), "bfs: there is no source; give at least one vert", invalid_argument);
  CHECK(bfs(r, std::vector<vert_id>(10000, vert_id{5}))[vert_id{1}] == 3);  // each source enters the queue once
}

TEST_CASE("bfs: may_enter excludes nodes, but not the source") {
  const ring r{7};
  const auto b = vert_id{1};
  const auto hops = bfs(r, vert_id{0}, {.may_enter = [b](auto v) { return v != b; }});
  CHECK(hops[vert_id{1}] == -1);
  CHECK(hops[vert_id{2}] == 5);
  CHECK(bfs(r, b, {.may_enter = [b](auto v) { return v != b; }})[vert_id{4}] == 3);
  CHECK(bfs(r, {vert_id{0}, vert_id{2}}, {.may_enter = [b](auto v) { return v != b; }})[vert_id{4}] == 2);
}

TEST_CASE("bfs: throws if the source is not in the mesh") {
  const ring r{3};
  CHECK_THROWS_WITH_AS(bfs(r, vert_id{3}), "bfs: the source is not a vert of the mesh; take one from verts(m)", invalid_mesh);
  CHECK_THROWS_AS(bfs(r, {vert_id{0}, vert_id{}}), invalid_mesh);
}

TEST_CASE("bfs: rejects temporaries, and calls without source or mesh, by constraints") {
  static_assert(searchable<ring&> && searchable<const ring&> && !searchable<ring> && !searchable<int&>);
  static_assert(!searchable<ring&, poly_id> && !searchable<ring&, int> && searchable<ring&, std::vector<vert_id>>);
}

TEST_CASE_TEMPLATE("bfs: equals Boost's on verts and polys, with components and isolated verts", M, CONCINO_KINDS) {
  const M m = two_grids<M>(2);
  const auto primal = make_boost_graph(vert_index_bound(m), primal_arcs(m, one));
  const auto dual = make_boost_graph(poly_index_bound(m), dual_arcs(m, one));
  for (const auto v : verts(m)) {
    const auto hops = bfs(m, v);
    const auto expected = boost_hops(primal, index_of(m, v));
    for (const auto w : verts(m)) REQUIRE(hops[w] == expected[index_of(m, w)]);
  }
  for (const auto p : polys(m)) {
    const auto hops = bfs(m, p);
    const auto expected = boost_hops(dual, index_of(m, p));
    for (const auto q : polys(m)) REQUIRE(hops[q] == expected[index_of(m, q)]);
  }
}

TEST_CASE_TEMPLATE("bfs: runs on the archetypes of primal and dual graphs", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  const auto g = only_primal_graph(m);
  const auto d = only_dual_graph(m);
  const auto v = *verts(m).begin();
  const auto p = *polys(m).begin();
  const auto hops = bfs(m, v);
  const auto stripped = bfs(g, g.vert(v), {.may_enter = [](auto) { return true; }});
  for (const auto w : verts(g)) CHECK(stripped[w] == hops[g.base(w)]);
  const auto across = bfs(m, p);
  const auto stripped_across = bfs(d, {d.poly(p)});
  for (const auto q : polys(d)) CHECK(stripped_across[q] == across[d.base(q)]);
}

TEST_CASE("bfs: the dual graph of n^3 hexes has 3 n^2 (n - 1) edges, and 3 (n - 1) hops from a corner") {
  const unsigned n = 4;
  const hexmesh m = grid<hexmesh>(n);
  std::size_t arcs = 0;
  int farthest = 0;
  const auto hops = bfs(m, poly_id{0});
  for (const auto p : polys(m)) {
    for ([[maybe_unused]] const auto q : adj_p2p(m, p)) ++arcs;
    farthest = std::max(farthest, hops[p]);
  }
  CHECK(arcs == 2 * 3 * n * n * (n - 1));
  CHECK(farthest == 3 * (int(n) - 1));
}

TEST_CASE_TEMPLATE("bfs: stops at bounds and targets, and stores predecessors, on verts and polys", M, CONCINO_KINDS) {
  const M m = grid<M>(3);
  const auto check = [&](const auto s, const auto nodes, auto before) {
    using node = std::remove_const_t<decltype(s)>;
    const auto hops = bfs(m, s);
    for (int most = 0; most < 4; ++most) {
      const auto near = bfs(m, s, {.max_hops = most});
      for (const auto x : nodes) REQUIRE(near[x] == (hops[x] <= most ? hops[x] : -1));
    }
    const auto again = bfs(m, {s, s}, {.predecessors = &before});
    const auto often = bfs(m, std::vector<node>(10000, s));
    for (const auto x : nodes) {
      REQUIRE(again[x] == hops[x]);
      REQUIRE(often[x] == hops[x]);
      if (x == s) REQUIRE(before[x] == s);
      else REQUIRE(hops[before[x]] == hops[x] - 1);
    }
    const auto everywhere = bfs(m, s, {.may_cross = [](auto) { return true; }});
    const auto nowhere = bfs(m, s, {.may_cross = [](auto) { return false; }});
    for (const auto x : nodes) {
      REQUIRE(everywhere[x] == hops[x]);
      REQUIRE(nowhere[x] == (x == s ? 0 : -1));
    }
    const node a{1}, b{static_cast<unsigned>(hops.values().size() - 1)};
    const int nearer = std::min(hops[a], hops[b]), farther = std::max(hops[a], hops[b]);
    const auto all = bfs(m, s, {.targets = {a, b, a}}), one_of_them = bfs(m, s, {.targets = {a, b}, .nearest_target = true});
    for (const auto x : nodes) {
      REQUIRE(all[x] == (hops[x] <= farther ? hops[x] : -1));
      REQUIRE(one_of_them[x] == (hops[x] <= nearer ? hops[x] : -1));
    }
    const auto around = bfs(m, s, {.may_enter = [a](const node& x) { return x != a; }});
    const auto same = bfs(m, s, {.may_enter = [a](const node& x) { return x != a; }, .max_hops = 1000});
    CHECK(around[a] == -1);
    for (const auto x : nodes) REQUIRE(around[x] == same[x]);
    CHECK_THROWS_WITH_AS(bfs(m, s, {.max_hops = -1}), "bfs: max_hops is -1; it must be 0 or more", invalid_argument);
  };
  check(vert_id{0}, verts(m), make_vert_map<vert_id>(m));
  check(poly_id{0}, polys(m), make_poly_map<poly_id>(m));
}

TEST_CASE_TEMPLATE("bfs: each crossed element is between a node and its predecessor; visit is called in search order", M, CONCINO_KINDS) {
  const M m = two_grids<M>(3);
  const auto check = [&](const auto s, const auto nodes, auto before, auto across, const auto& is_between) {
    using node = std::remove_const_t<decltype(s)>;
    const auto hops = bfs(m, s);
    std::vector<node> order;
    bool known = true;  // whether all that visit may rely on is true
    const auto again = bfs(m, s, {.predecessors = &before, .crossed = &across, .visit = [&](const node& x, int h) {
                                    known = known && h == hops[x] && (h == 0 ? before[x] == x : is_between(across[x], x) && is_between(across[x], before[x]));
                                    order.push_back(x);
                                    return true;
                                  }});
    CHECK(known);
    CHECK(order.front() == s);
    std::size_t reached = 0;
    for (const auto x : nodes) {
      reached += hops[x] >= 0;
      REQUIRE(again[x] == hops[x]);
    }
    CHECK(order.size() == reached);
    for (std::size_t i = 1; i < order.size(); ++i) REQUIRE(hops[order[i - 1]] <= hops[order[i]]);

    // visit ends the search at the source, or at the third node.
    for (std::size_t most : {std::size_t{1}, std::size_t{3}}) {
      std::vector<node> seen;
      const auto part = bfs(m, s, {.visit = [&](const node& x, int) {
                              seen.push_back(x);
                              return seen.size() < most;
                            }});
      REQUIRE(seen.size() == most);
      for (const auto x : nodes) {
        const bool is_seen = std::find(seen.begin(), seen.end(), x) != seen.end();
        REQUIRE(part[x] == (is_seen ? hops[x] : -1));
      }
    }
    const auto none = bfs(m, std::vector{s, node{1}}, {.visit = [](const node&, int) { return false; }});
    for (const auto x : nodes) REQUIRE(none[x] == (x == s ? 0 : -1));
  };
  check(vert_id{0}, verts(m), make_vert_map<vert_id>(m), make_vert_map<edge_id>(m), [&](edge_id e, vert_id v) {
    bool any = false;
    for (const auto w : adj_e2v(m, e)) any = any || w == v;
    return any;
  });
  if constexpr (dimension_v<M> == 2)
    check(poly_id{0}, polys(m), make_poly_map<poly_id>(m), make_poly_map<edge_id>(m), [&](edge_id e, poly_id p) {
      bool any = false;
      for (const auto q : adj_e2p(m, e)) any = any || q == p;
      return any;
    });
  else
    check(poly_id{0}, polys(m), make_poly_map<poly_id>(m), make_poly_map<face_id>(m), [&](face_id f, poly_id p) {
      bool any = false;
      for (const auto q : adj_f2p(m, f)) any = any || q == p;
      return any;
    });
}

TEST_CASE_TEMPLATE("bfs_forest: has a tree for each component, equal to bfs from its first node", M, CONCINO_KINDS) {
  const M m = two_grids<M>(2);
  const auto check = [&](const auto& graph, const auto nodes, auto before) {
    using node = std::remove_cvref_t<decltype(*nodes.begin())>;
    std::vector<node> order, roots;
    const auto hops = bfs_forest(graph, {.predecessors = &before, .visit = [&](const node& x, int h) {
                                           if (h == 0) roots.push_back(x);
                                           order.push_back(x);
                                           return true;
                                         }});
    const auto plain = bfs_forest(graph);
    std::vector<node> expected;
    for (const node& root : roots)
      bfs(graph, root, {.visit = [&](const node& x, int h) {
            expected.push_back(x);
            return h == hops[x] && (h > 0 || before[x] == x);
          }});
    CHECK(order == expected);
    std::size_t count = 0;
    for (const auto x : nodes) {
      ++count;
      REQUIRE(hops[x] >= 0);
      REQUIRE(plain[x] == hops[x]);
    }
    CHECK(order.size() == count);
    CHECK(roots.size() >= 2);

    // Nodes that may not be entered are in no tree. With max_hops = 0 every other node is a root.
    const node barred = order[1];
    const auto around = bfs_forest(graph, {.may_enter = [&](const node& x) { return x != barred; }, .max_hops = 0});
    for (const auto x : nodes) REQUIRE(around[x] == (x == barred ? -1 : 0));
    // The search ends after the tree that contains the target, or when visit returns false.
    const auto first = bfs_forest(graph, {.targets = {roots[0]}});
    const auto all = bfs_forest(graph, {.targets = {roots[1]}});
    int met = 0;
    const auto some = bfs_forest(graph, {.visit = [&](const node&, int) { return ++met < 2; }});
    std::size_t n = 0;
    for (const auto x : nodes) {
      REQUIRE(first[x] == (x == roots[0] ? 0 : -1));
      if (hops[x] >= 0 && x == roots[1]) REQUIRE(all[x] == 0);
      n += some[x] >= 0;
    }
    CHECK(n == 2);
    CHECK_THROWS_WITH_AS(bfs_forest(graph, {.max_hops = -1}), "bfs_forest: max_hops is -1; it must be 0 or more", invalid_argument);
  };
  check(m, verts(m), make_vert_map<vert_id>(m));
  check(dual(m), polys(m), make_poly_map<poly_id>(m));
  const auto g = only_primal_graph(m);
  const auto hops = bfs_forest(m);
  const auto stripped = bfs_forest(g);
  for (const auto w : verts(g)) CHECK(stripped[w] == hops[g.base(w)]);
  static_assert(has_forest<M&> && !has_forest<M> && !has_forest<int&>);
}
