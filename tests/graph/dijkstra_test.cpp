#include <concino/graph/dijkstra.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit/elements.hpp>
#include <concino/graph/bfs.hpp>

#include <support/boost_graph.hpp>
#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

template<class M>
auto straight(const M& m) {
  return [&m](vert_t<M> v, vert_t<M> w) { return norm(to_vec3(point(m, v)) - to_vec3(point(m, w))); };
}

/// The distance between mean points, computed in another way than by the library.
template<class M>
auto centre_to_centre(const M& m) {
  return [&m](poly_t<M> p, poly_t<M> q) {
    const auto mean = [&m](poly_t<M> x) {
      double c[4] = {0, 0, 0, 0};
      for (const auto v : adj_p2v(m, x)) {
        for (std::size_t k = 0; k < 3; ++k) c[k] += point(m, v)[k];
        c[3] += 1;
      }
      return vec3{c[0] / c[3], c[1] / c[3], c[2] / c[3]};
    };
    return norm(mean(p) - mean(q));
  };
}

/// A length that depends on the indices and the direction, and is different for nearly all arcs.
constexpr auto scrambled = [](auto v, auto w) { return double((v.raw() * 2654435761u + w.raw() * 40503u) % 1009) / 64; };

}  // namespace

TEST_CASE_TEMPLATE("dijkstra: equals Boost's on verts and polys, with components and isolated verts", M, CONCINO_ALL_KINDS) {
  const M m(jittered(two_grids_arrays<M>(2), 0.05));
  const auto compare = [&](const auto& arcs, std::size_t bound, const auto& all, const auto& mine) {
    const auto g = make_boost_graph(bound, arcs);
    for (const auto s : all) {
      const auto d = mine(s);
      const auto expected = boost_distances(g, index_of(m, s));
      for (const auto x : all) {
        if (expected[index_of(m, x)] == inf) REQUIRE(d[x] == inf);
        else REQUIRE(d[x] == doctest::Approx(expected[index_of(m, x)]).epsilon(1e-13));
      }
    }
  };
  compare(primal_arcs(m, straight(m)), vert_index_bound(m), verts(m), [&](auto s) { return dijkstra(m, s); });
  compare(primal_arcs(m, scrambled), vert_index_bound(m), verts(m), [&](auto s) { return dijkstra(m, s, scrambled); });
  compare(dual_arcs(m, centre_to_centre(m)), poly_index_bound(m), polys(m), [&](auto s) { return dijkstra(m, s); });
  compare(dual_arcs(m, scrambled), poly_index_bound(m), polys(m), [&](auto s) { return dijkstra(m, s, scrambled); });
}

TEST_CASE_TEMPLATE("dijkstra: scales exactly, down to where squares underflow", M, CONCINO_ALL_KINDS) {
  auto arrays = jittered(grid_arrays<M>(3), 0.05);
  const M m(arrays);
  const auto d = dijkstra(m, vert_id{0});
  const auto c = dijkstra(m, poly_id{0});
  for (const double scale : {0x1p-20, 0x1p20, 0x1p-120}) {
    auto scaled = arrays;
    for (vec3& p : scaled.points) p *= scale;
    const M s(scaled);
    const auto ds = dijkstra(s, vert_id{0});
    const auto cs = dijkstra(s, poly_id{0});
    for (const auto v : verts(m)) CHECK(ds[v] == d[v] * scale);
    for (const auto p : polys(m)) CHECK(cs[p] == c[p] * scale);
  }
  for (const double scale : {1e-170, 1e160}) {
    auto scaled = arrays;
    for (vec3& p : scaled.points) p *= scale;
    const M s(scaled);
    const auto ds = dijkstra(s, vert_id{0});
    for (const auto v : verts(m)) CHECK(ds[v] == doctest::Approx(d[v] * scale).epsilon(1e-12));
  }
}

TEST_CASE_TEMPLATE("dijkstra: runs on the archetype of its concept", M, CONCINO_ALL_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05));
  const auto v = *verts(m).begin();
  const auto p = *polys(m).begin();
  const auto d = dijkstra(m, v);
  const auto c = dijkstra(m, p);

  const auto bare = only_primal_graph(m);
  const auto by_length = dijkstra(bare, bare.vert(v), [&](const auto& a, const auto& b) { return straight(m)(bare.base(a), bare.base(b)); });
  for (const auto w : verts(bare)) CHECK(by_length[w] == d[bare.base(w)]);

  const auto embedded = only_embedded_graph(m);
  const auto straight_lines = dijkstra(embedded, embedded.vert(v), {.targets = {}, .may_enter = [](auto) { return true; }});
  for (const auto w : verts(embedded)) CHECK(straight_lines[w] == d[embedded.base(w)]);

  const auto dual = only_dual_graph(m);
  const auto steps = dijkstra(dual, {dual.poly(p)}, [](const auto&, const auto&) { return 1; });
  const auto expected = dijkstra(m, p, [](auto, auto) { return 1; });
  for (const auto q : polys(dual)) CHECK(steps[q] == expected[dual.base(q)]);

  const auto mesh = only_embedded_mesh(m);
  const auto across = dijkstra(mesh, mesh.poly(p), {.targets = {}});
  for (const auto q : polys(mesh)) CHECK(across[q] == c[mesh.base(q)]);
}

TEST_CASE_TEMPLATE("dijkstra: returns the distance to the nearest of several sources", M, CONCINO_ALL_KINDS) {
  const M m(jittered(grid_arrays<M>(3), 0.02));
  const vert_id a{0}, b{static_cast<unsigned>(num_verts(m) - 1)};
  const auto da = dijkstra(m, a), db = dijkstra(m, b), both = dijkstra(m, {a, b}), listed = dijkstra(m, std::vector{b, a, b}, straight(m));
  for (const auto v : verts(m)) {
    CHECK(both[v] == std::min(da[v], db[v]));
    CHECK(listed[v] == std::min(da[v], db[v]));
  }
}

TEST_CASE_TEMPLATE("dijkstra: stops at targets: distances are exact up to the farthest, and +inf beyond", M, CONCINO_ALL_KINDS) {
  const M m = grid<M>(4);  // has many equal distances
  const auto d = dijkstra(m, vert_id{0});
  const vert_id near{1}, far{static_cast<unsigned>(num_verts(m) / 2)};
  const auto stopped = dijkstra(m, vert_id{0}, {.targets = {near, far, near}});
  const double limit = std::max(d[near], d[far]);
  std::size_t left = 0;
  for (const auto v : verts(m)) {
    CHECK(stopped[v] == (d[v] <= limit ? d[v] : inf));
    left += stopped[v] == inf;
  }
  CHECK(left > 0);
  const auto only_source = dijkstra(m, poly_id{0}, {.targets = {poly_id{0}}});
  CHECK(only_source[poly_id{0}] == 0);
  CHECK(only_source[poly_id{1}] == inf);
}

TEST_CASE_TEMPLATE("dijkstra: paths go around excluded nodes; a barrier separates the mesh", M, CONCINO_ALL_KINDS) {
  const M m = grid<M>(4);
  const auto free = [&](auto v) { return point(m, v)[0] != 0.5; };
  const auto d = dijkstra(m, vert_id{0}, {.may_enter = free});
  for (const auto v : verts(m)) CHECK((d[v] == inf) == (point(m, v)[0] >= 0.5));

  const auto hole = [&](auto v) { return point(m, v)[0] != 0.5 || point(m, v)[1] >= 0.75; };
  const auto around = dijkstra(m, vert_id{0}, straight(m), {.may_enter = hole});
  std::vector<arc> arcs;
  for (const arc& a : primal_arcs(m, straight(m)))
    if (hole(vert_id{a.to})) arcs.push_back(a);
  const auto expected = boost_distances(make_boost_graph(vert_index_bound(m), arcs), 0);
  for (const auto v : verts(m)) CHECK(std::min(around[v], 1e9) == doctest::Approx(std::min(expected[index_of(m, v)], 1e9)));
}

TEST_CASE_TEMPLATE("dijkstra: distances obey the triangle inequality along every arc", M, CONCINO_ALL_KINDS) {
  const M m(jittered(grid_arrays<M>(3), 0.05, true, 7));
  const auto d = dijkstra(m, vert_id{2}, scrambled);
  for (const auto v : verts(m)) {
    bool reached = v == vert_id{2};
    for (const auto w : adj_v2v(m, v)) {
      CHECK(d[w] <= d[v] + scrambled(v, w));
      reached = reached || d[v] == d[w] + scrambled(w, v);
    }
    CHECK(reached);
  }
}

TEST_CASE("dijkstra: accepts zero and infinite lengths") {
  const auto m = grid<trimesh>(3);
  const auto zero = dijkstra(m, vert_id{0}, [](auto, auto) { return 0.0; }, {.targets = {vert_id{15}}});
  for (const auto v : verts(m)) CHECK(zero[v] == 0);
  const auto cut = dijkstra(m, vert_id{0}, [](auto, auto) { return inf; });
  CHECK(cut[vert_id{0}] == 0);
  CHECK(cut[vert_id{1}] == inf);
}

TEST_CASE("dijkstra: throws if an argument is invalid") {
  const auto m = grid<trimesh>(2);
  CHECK_THROWS_WITH_AS(dijkstra(m, vert_id{9}), "dijkstra: the source is not a vert of the mesh; take one from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(dijkstra(m, poly_id{8}), "dijkstra: the source is not a poly of the mesh; take one from polys(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(dijkstra(m, vert_id{0}, {.targets = {vert_id{9}}}), "dijkstra: the target is not a vert of the mesh; take one from verts(m)", invalid_mesh);
  const auto negative = [](auto v, auto) { return v.raw() == 1 ? -0.5 : 1.0; };
  CHECK_THROWS_WITH_AS(dijkstra(m, vert_id{1}, negative), doctest::Contains("dijkstra: the length from vert 1 to vert "), invalid_mesh);
  CHECK_THROWS_WITH_AS(dijkstra(m, poly_id{1}, negative), doctest::Contains("is -0.5; lengths must be 0 or more"), invalid_mesh);
  CHECK_THROWS_WITH_AS(dijkstra(m, vert_id{0}, [](auto, auto) { return std::nan(""); }), doctest::Contains("is not a number"), invalid_mesh);
}

TEST_CASE("dijkstra: its constraints accept exactly the calls that compile") {
  static_assert(requirement::has_lengths<trimesh, vert_id> && requirement::has_lengths<const tetmesh&, poly_id>);
  static_assert(!requirement::has_lengths<trimesh, edge_id> && !requirement::has_lengths<int, vert_id>);
  using bare = decltype(only_primal_graph(std::declval<const trimesh&>()));
  static_assert(requirement::is_source<bare, vert_t<bare>> && !requirement::has_lengths<bare, vert_t<bare>>);
}

TEST_CASE("dijkstra: goes around a regular polygon up to the vert before the antipode") {
  std::vector<vec3> points;
  std::vector<std::vector<int>> polygon(1);
  const int n = 101;
  for (int i = 0; i < n; ++i) {
    points.push_back({std::cos(2 * std::numbers::pi * i / n), std::sin(2 * std::numbers::pi * i / n), 0});
    polygon[0].push_back(i);
  }
  const polygonmesh m(points, polygon);
  const auto d = dijkstra(m, vert_id{0});
  for (int i = 0; i < n; ++i) CHECK(d[vert_id{i}] == doctest::Approx(std::min(i, n - i) * 2 * std::sin(std::numbers::pi / n)).epsilon(1e-13));
}

TEST_CASE_TEMPLATE("dijkstra, bfs: work with gaps in the indices", M, CONCINO_ALL_KINDS) {
  M m(jittered(grid_arrays<M>(3), 0.05));
  const vert_id gone{static_cast<unsigned>(num_verts(m) / 2)};
  const poly_id hole = *adj_v2p(m, gone).begin();
  remove_vert(m, gone);
  remove_poly(m, *polys(m).begin());
  CHECK(vert_index_bound(m) > num_verts(m));
  const auto g = make_boost_graph(vert_index_bound(m), primal_arcs(m, straight(m)));
  const auto dual = make_boost_graph(poly_index_bound(m), dual_arcs(m, centre_to_centre(m)));
  const auto s = *verts(m).begin();
  const auto p = *polys(m).begin();
  const auto d = dijkstra(m, s);
  const auto expected = boost_distances(g, index_of(m, s));
  const auto hops = bfs(m, s);
  const auto expected_hops = boost_hops(g, index_of(m, s));
  for (const auto v : verts(m)) {
    CHECK(std::min(d[v], 1e9) == doctest::Approx(std::min(expected[index_of(m, v)], 1e9)).epsilon(1e-13));
    CHECK(hops[v] == expected_hops[index_of(m, v)]);
  }
  const auto across = dijkstra(m, p);
  const auto expected_across = boost_distances(dual, index_of(m, p));
  for (const auto q : polys(m)) CHECK(std::min(across[q], 1e9) == doctest::Approx(std::min(expected_across[index_of(m, q)], 1e9)).epsilon(1e-13));
  CHECK_THROWS_AS(dijkstra(m, gone), invalid_mesh);
  CHECK_THROWS_AS(bfs(m, hole), invalid_mesh);
}

TEST_CASE("dijkstra: runs on a user's mesh, and throws if a coordinate is NaN") {
  user_mesh::surface m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2, 3}, {1, 4, 2}});
  const auto d = dijkstra(m, user_mesh::vertex{0});
  CHECK(d[user_mesh::vertex{4}] == 2);
  CHECK(dijkstra(m, {user_mesh::cell{0}})[user_mesh::cell{1}] == doctest::Approx(std::hypot(4.0 / 3 - 0.5, 1.0 / 3 - 0.5)));
  m.points[4][1] = std::nan("");
  for (const auto v : verts(m)) CHECK_THROWS_WITH_AS(dijkstra(m, v), doctest::Contains("is not a number"), invalid_mesh);
  for (const auto p : polys(m)) CHECK_THROWS_WITH_AS(dijkstra(m, p), doctest::Contains("is not a number"), invalid_mesh);
  m.points[4][1] = inf;
  CHECK(dijkstra(m, user_mesh::vertex{0})[user_mesh::vertex{4}] == inf);
}

TEST_CASE("dijkstra: comparing squared lengths is exact at any scale") {
  std::mt19937_64 random(4);
  const auto any = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
  for (const int scale : {0, -600, -550, -540, -530, -500, 500})
    for (int i = 0; i < 500; ++i) {
      const vec3 step{std::ldexp(any(), scale), std::ldexp(any(), scale), std::ldexp(any(), scale)};
      const double length = norm(step), gap = std::nextafter(length, std::numeric_limits<double>::infinity());
      REQUIRE(concino::detail::distance_below(vec3{}, step, gap) == length);
    }
}

TEST_CASE_TEMPLATE("dijkstra: obeys initial distances, may_cross and visit, on verts and polys", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(3), 0.05));
  const auto check = [&](const auto nodes, const auto& length, auto before, auto across, const auto& is_between) {
    using node = std::remove_cvref_t<decltype(*nodes.begin())>;
    const node a{0}, b{5}, c{3};
    const auto from_a = dijkstra(m, a, length), from_b = dijkstra(m, b, length);
    for (const double ahead : {-2.5, 0.25, 100.0, inf}) {
      std::vector<node> order;
      bool known = true;
      const auto d = dijkstra(m, {a, b}, length,
                              {.predecessors = &before,
                               .crossed = &across,
                               .visit = [&](const node& x, double) {
                                 known = known && (before[x] == x || (is_between(across[x], x) && is_between(across[x], before[x])));
                                 order.push_back(x);
                                 return true;
                               },
                               .initial_distance = [&](const node& x) { return x == a ? 0.0 : ahead; }});
      CHECK(known);
      std::size_t reached = 0;
      for (const auto x : nodes) {
        reached += d[x] < inf;
        const double expected = std::min(from_a[x], ahead + from_b[x]);
        if (expected < inf) REQUIRE(d[x] == doctest::Approx(expected).epsilon(1e-13));
        else REQUIRE(d[x] == inf);
        if (before[x] == x) REQUIRE((d[x] == inf || x == a || x == b));
        else REQUIRE(d[before[x]] + length(before[x], x) == d[x]);
      }
      if (ahead >= 100) REQUIRE(!(before[b] == b));
      REQUIRE(order.size() == reached);
      for (std::size_t i = 1; i < order.size(); ++i) REQUIRE(d[order[i - 1]] <= d[order[i]]);
    }
    // Without predecessors and other outputs; then visit ends the search at the fourth node.
    const auto plain = dijkstra(m, std::vector{b, a, b}, length, {.initial_distance = [&](const node& x) { return x == a ? -1.0 : 0.5; }});
    for (const auto x : nodes) REQUIRE(plain[x] == doctest::Approx(std::min(from_a[x] - 1, from_b[x] + 0.5)).epsilon(1e-13));
    std::vector<node> seen;
    const auto part = dijkstra(m, c, length, {.predecessors = &before, .visit = [&](const node& x, double) {
                                 seen.push_back(x);
                                 return seen.size() < 4;
                               }});
    const auto all = dijkstra(m, c, length);
    REQUIRE(seen.size() == 4);
    for (const auto x : nodes) {
      const bool is_seen = std::find(seen.begin(), seen.end(), x) != seen.end();
      REQUIRE(part[x] == (is_seen ? all[x] : inf));
      if (!is_seen) REQUIRE(before[x] == x);
      else if (!(x == c)) REQUIRE(!(before[x] == x));
    }
    CHECK_THROWS_WITH_AS(dijkstra(m, a, length, {.initial_distance = [](const node&) { return std::nan(""); }}),
                         doctest::Contains("0 is not a number; give a number, or +inf for no source"), invalid_argument);
    CHECK_THROWS_WITH_AS(dijkstra(m, a, length, {.initial_distance = [](const node&) { return -inf; }}), doctest::Contains("0 is -inf"), invalid_argument);
  };
  const auto is_in = [](const auto range, const auto& x) {
    bool any = false;
    for (const auto y : range) any = any || y == x;
    return any;
  };
  check(verts(m), straight(m), make_vert_map<vert_id>(m), make_vert_map<edge_id>(m), [&](edge_id e, vert_id v) { return is_in(adj_e2v(m, e), v); });
  if constexpr (dimension_v<M> == 2)
    check(polys(m), centre_to_centre(m), make_poly_map<poly_id>(m), make_poly_map<edge_id>(m), [&](edge_id e, poly_id p) { return is_in(adj_e2p(m, e), p); });
  else
    check(polys(m), centre_to_centre(m), make_poly_map<poly_id>(m), make_poly_map<face_id>(m), [&](face_id f, poly_id p) { return is_in(adj_f2p(m, f), p); });
}
