#include <concino/graph/shortest_path.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/barred_graph.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE_TEMPLATE("shortest_path: is a path with the length of Boost's, on random meshes", M, CONCINO_KINDS) {
  for_random_graphs<M>(num_random_meshes(), [](const auto& g) {
    const auto& m = g.m;
    const auto nodes = g.nodes();
    if (nodes.empty()) return;
    const auto pick = [&](unsigned i) { return nodes[(g.salt >> i) % nodes.size()]; };
    const auto length = g.length();
    const auto boost = make_boost_graph(g.bound(), g.arcs(length));
    const std::vector sources = {pick(0), pick(4)}, targets = {pick(8), pick(12), pick(16)};
    double shortest = inf;
    auto nearest = targets[0];
    for (const auto t : targets)
      for (const auto s : sources)
        if (const double d = boost_distances(boost, index_of(m, s))[index_of(m, t)]; d < shortest) {
          shortest = d;
          nearest = t;
        }

    const auto path = shortest_path(m, sources, targets, length, {.may_enter = g.enter(), .may_cross = g.cross()});
    REQUIRE(path.empty() == (shortest == inf));
    if (path.empty()) return;
    double sum = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      REQUIRE(g.has_arc(path[i - 1], path[i]));
      sum += length(path[i - 1], path[i]);
    }
    REQUIRE(sum == shortest);
    REQUIRE(std::find(sources.begin(), sources.end(), path.front()) != sources.end());
    REQUIRE(path.back() == nearest);
    REQUIRE(path == shortest_path(m, sources, targets, length, {.may_enter = g.enter(), .may_cross = g.cross()}));
    REQUIRE(path == shortest_path(m, sources, targets, length, {.may_enter = g.enter(), .may_cross = g.cross(), .max_distance = shortest}));
    if (shortest > 0)
      REQUIRE(shortest_path(m, sources, targets, length, {.may_enter = g.enter(), .may_cross = g.cross(), .max_distance = shortest / 2}).empty());
  });
}

TEST_CASE_TEMPLATE("shortest_path: default lengths are distances, from a vert or a poly", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(3), 0.05));
  const auto sum = [&](const auto& path, const auto& at) {
    double s = 0;
    for (std::size_t i = 1; i < path.size(); ++i) s += norm(at(path[i]) - at(path[i - 1]));
    return s;
  };
  const auto d = dijkstra(m, vert_id{0});
  const auto c = dijkstra(m, poly_id{0});
  for (const auto v : verts(m)) CHECK(sum(shortest_path(m, vert_id{0}, v), [&](auto x) { return to_vec3(point(m, x)); }) == doctest::Approx(d[v]).epsilon(1e-13));
  for (const auto p : polys(m)) CHECK(sum(shortest_path(m, poly_id{0}, p), [&](auto x) { return vert_mean(m, x); }) == doctest::Approx(c[p]).epsilon(1e-13));
}

TEST_CASE("shortest_path: handles trivial and missing paths, barriers and braces") {
  const auto m = two_grids<quadmesh>(3);
  const vert_id a{0}, b{2}, beyond{16 + 1};
  CHECK(shortest_path(m, a, a) == std::vector{a});
  CHECK(shortest_path(m, a, beyond).empty());
  CHECK(shortest_path(m, a, b) == std::vector<vert_id>{a, vert_id{1}, b});
  CHECK(shortest_path(m, a, b, {.may_enter = [](auto v) { return v != vert_id{1}; }}).size() == 5);
  CHECK(shortest_path(m, a, b, {.may_enter = [b](auto v) { return v != b; }}).empty());
  CHECK(shortest_path(m, a, a, {.may_enter = [](auto) { return false; }}) == std::vector{a});
  const auto first = [&](edge_id e) {
    const auto ends = adj_e2v(m, e);
    return !((*ends.begin()).raw() + (*std::next(ends.begin())).raw() == 1);
  };
  CHECK(shortest_path(m, a, b, {.may_cross = first}).size() == 5);
  CHECK(shortest_path(primal(m), a, b, {.may_cross = first}).size() == 5);
  CHECK(shortest_path(m, {a, beyond}, {b, vert_id{16}}) == std::vector<vert_id>{beyond, vert_id{16}});
  CHECK(shortest_path(m, {a}, {b}, [](auto, auto) { return 1; }).size() == 3);
  CHECK_THROWS_WITH_AS(shortest_path(m, a, std::vector<vert_id>{}), "shortest_path: there is no target; give at least one vert", invalid_argument);
  CHECK_THROWS_WITH_AS(shortest_path(m, std::vector<vert_id>{}, a), "shortest_path: there is no source; give at least one vert", invalid_argument);
  CHECK(shortest_path(m, vert_id{5}, {vert_id{9}, vert_id{6}, vert_id{4}}).back() == vert_id{9});  // all are at equal distance
  CHECK(shortest_path(dual(m), poly_id{0}, poly_id{2}) == std::vector<poly_id>{poly_id{0}, poly_id{1}, poly_id{2}});
}

TEST_CASE_TEMPLATE("shortest_path: runs on the archetype of its concept", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  const auto one = [](const auto&, const auto&) { return 1.0; };
  const vert_id v{0}, w{static_cast<unsigned>(num_verts(m) - 1)};
  const poly_id p{0}, q{static_cast<unsigned>(num_polys(m) - 1)};
  const auto bare = only_primal_graph(m);
  const auto path = shortest_path(bare, bare.vert(v), bare.vert(w), one);
  CHECK(path.size() == shortest_path(m, v, w, one).size());
  CHECK(bare.base(path.back()) == w);
  const auto cells = only_dual_graph(m);
  CHECK(shortest_path(cells, cells.poly(p), {cells.poly(q)}, one, {.may_enter = [](const auto&) { return true; }}).size() == shortest_path(m, p, q, one).size());
  const auto embedded = only_embedded_graph(m);
  CHECK(shortest_path(embedded, {embedded.vert(v)}, embedded.vert(w)).size() == shortest_path(m, v, w).size());
  const auto mesh = only_embedded_mesh(m);
  CHECK(shortest_path(mesh, mesh.poly(p), mesh.poly(q), {.may_cross = [](const auto&) { return true; }}).size() == shortest_path(m, p, q).size());
}

TEST_CASE("shortest_path: throws if an argument is invalid") {
  const auto m = grid<trimesh>(2);
  const vert_id a{0}, none{9};
  CHECK_THROWS_WITH_AS(shortest_path(m, none, a), "shortest_path: the source is not a vert of the mesh; take one from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(shortest_path(m, a, none), "shortest_path: the target is not a vert of the mesh; take one from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(shortest_path(m, poly_id{0}, {poly_id{1}, poly_id{8}}), "shortest_path: the target is not a poly of the mesh; take one from polys(m)",
                       invalid_mesh);
  CHECK_THROWS_WITH_AS(shortest_path(m, a, vert_id{8}, [](auto, auto) { return -1.0; }), doctest::Contains("shortest_path: the length from vert 0 to vert "),
                       invalid_mesh);
  CHECK_THROWS_WITH_AS(shortest_path(m, a, vert_id{8}, [](auto, auto) { return std::nan(""); }), doctest::Contains("is not a number"), invalid_mesh);
  CHECK_THROWS_WITH_AS(shortest_path(m, a, vert_id{8}, {.max_distance = -1}), "shortest_path: max_distance must be 0 or more", invalid_argument);
}

TEST_CASE("shortest_path: its constraints accept exactly the calls that compile; runs on a user's mesh") {
  static_assert(requirement::is_target<trimesh, vert_id, vert_id> && requirement::is_target<trimesh, poly_id, std::vector<poly_id>>);
  static_assert(!requirement::is_target<trimesh, vert_id, poly_id> && !requirement::is_target<int, vert_id, vert_id>);
  const auto m = user_mesh::surface_example();
  CHECK(shortest_path(m, user_mesh::vertex{1}, user_mesh::vertex{5}) == std::vector{user_mesh::vertex{1}, user_mesh::vertex{0}, user_mesh::vertex{6}, user_mesh::vertex{5}});
  CHECK(shortest_path(m, user_mesh::cell{0}, user_mesh::cell{3}, {.may_cross = [](user_mesh::segment) { return false; }}).empty());
}
