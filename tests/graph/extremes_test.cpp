// Graph algorithms on empty meshes, single verts, long strips and verts of high degree.
#include <concino/graph.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr auto one = [](const auto&, const auto&) { return 1.0; };

}  // namespace

TEST_CASE_TEMPLATE("graphs: algorithms work on empty meshes and on a single vert", M, CONCINO_KINDS) {
  const M none;
  CHECK_THROWS_WITH_AS(bfs(none, std::vector<vert_id>{}), "bfs: there is no source; give at least one vert", invalid_argument);
  CHECK_THROWS_WITH_AS(dijkstra(none, std::vector<poly_id>{}, one), "dijkstra: there is no source; give at least one poly", invalid_argument);
  CHECK_THROWS_WITH_AS(dijkstra(none, std::vector<vert_id>{}), "dijkstra: there is no source; give at least one vert", invalid_argument);
  CHECK_THROWS_AS(shortest_path(none, std::vector<poly_id>{}, std::vector<poly_id>{}), invalid_argument);
  CHECK(connected_components(none).count == 0);
  CHECK(spanning_tree(dual(none)).arcs.empty());
  CHECK(spanning_tree(none, {.method = tree_method::prim}).arcs.empty());
  CHECK_THROWS_WITH_AS(grow_regions(none, std::vector<vert_id>{}, one), "grow_regions: there is no seed; give at least one vert", invalid_argument);
  CHECK_THROWS_AS(bfs(none, vert_id{0}), invalid_mesh);
  CHECK_THROWS_AS(dijkstra(none, poly_id{0}), invalid_mesh);

  auto arrays = grid_arrays<M>(1);
  arrays.points.push_back({9, 9, 9});
  const M m(arrays);
  const vert_id lonely{static_cast<unsigned>(num_verts(m) - 1)};
  CHECK(bfs(m, lonely)[lonely] == 0);
  CHECK(bfs(m, lonely)[vert_id{0}] == -1);
  CHECK(dijkstra(m, vert_id{0})[lonely] == inf);
  CHECK(shortest_path(m, vert_id{0}, lonely).empty());
  CHECK(connected_components(m).count == 2);
  CHECK(spanning_tree(m).arcs.size() == num_verts(m) - 2);
  CHECK(grow_regions(m, lonely, one)[vert_id{0}] == -1);
  if constexpr (dimension_v<M> == 2) {
    CHECK(boundary_loops(none).loops.empty());
    CHECK(tree_cotree(none).tree.empty());
    CHECK(homology_generators(none).empty());
    CHECK(cut_along(none, {}).surface.points.empty());
    CHECK(cut_along(m, {}).verts.size() == num_verts(m));
  }
}

TEST_CASE("graphs: algorithms work on a strip of 100,000 quads") {
  const unsigned n = 100000;
  surface_arrays s{{}, {}, {}, 4};
  for (unsigned i = 0; i <= n; ++i)
    for (const double y : {0.0, 1.0}) s.points.push_back({double(i), y, 0});
  for (unsigned i = 0; i < n; ++i)
    for (const unsigned v : {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1}) s.verts.push_back(vert_id{v});
  const quadmesh m(s);
  const poly_id first{0}, last{n - 1};
  CHECK(bfs(m, first)[last] == static_cast<int>(n) - 1);
  CHECK(dijkstra(m, vert_id{0})[vert_id{2 * n}] == n);
  CHECK(shortest_path(m, first, last, one).size() == n);
  CHECK(connected_components(dual(m)).count == 1);
  CHECK(spanning_tree(m).weight == 2 * n + 1);
  CHECK(grow_regions(m, {first, last}, one)[poly_id{n / 2}] == 1);
  REQUIRE(boundary_loops(m).loops.size() == 1);
  CHECK(boundary_loops(m).loops[0].edges.size() == 2 * n + 2);
}

TEST_CASE("graphs: algorithms work on two fans of 30,000 triangles with a common boundary") {
  const unsigned n = 30000;
  std::vector<vec3> x(n + 2);
  std::vector<std::array<unsigned, 3>> sides;
  for (unsigned i = 0; i < n; ++i) {
    x[i] = {double(i % 3), double(i % 7), double(i)};
    sides.push_back({i, (i + 1) % n, n});
    sides.push_back({(i + 1) % n, i, n + 1});
  }
  const trimesh m(x, sides);
  const vert_id apex{n};
  CHECK(bfs(m, apex)[vert_id{n + 1}] == 2);
  CHECK(dijkstra(m, apex, one)[vert_id{n + 1}] == 2);
  CHECK(connected_components(m).count == 1);
  CHECK(spanning_tree(m, one).weight == n + 1);
  CHECK(spanning_tree(dual(m), one, {.method = tree_method::prim}).weight == 2 * n - 1);
  CHECK(grow_regions(m, {vert_id{0}, apex}, one)[vert_id{n / 2}] == 1);
  CHECK(tree_cotree(m).rest.empty());
  CHECK(homology_generators(m).empty());
  std::vector<edge_id> spokes;
  for (const auto e : adj_v2e(m, apex)) spokes.push_back(e);
  CHECK(cut_along(m, spokes).verts.size() == n + 2 + n - 1);
}

TEST_CASE_TEMPLATE("graphs: algorithms handle points that are NaN or huge", M, CONCINO_KINDS) {
  M m = grid<M>(2);
  set_point(m, vert_id{1}, vec3{0, std::nan(""), 0});
  CHECK(bfs(m, vert_id{0})[vert_id{1}] == 1);
  CHECK(connected_components(m).count == 1);
  CHECK(dijkstra(m, vert_id{0}, one)[vert_id{1}] == 1);
  CHECK_THROWS_WITH_AS(dijkstra(m, vert_id{0}), doctest::Contains("dijkstra: the length from vert 0 to vert 1 is not a number"), invalid_mesh);
  CHECK_THROWS_WITH_AS(shortest_path(m, vert_id{0}, vert_id{2}), doctest::Contains("is not a number"), invalid_mesh);
  CHECK_THROWS_WITH_AS(spanning_tree(m), doctest::Contains("spanning_tree: the length from vert 0 to vert 1 is not a number"), invalid_mesh);
  CHECK_THROWS_WITH_AS(spanning_tree(dual(m)), doctest::Contains("is not a number"), invalid_mesh);
  set_point(m, vert_id{1}, vec3{0, inf, 0});  // a node at infinite distance is not reached
  CHECK(dijkstra(m, vert_id{0})[vert_id{1}] == inf);
  CHECK(spanning_tree(m).arcs.size() == num_verts(m) - 2);
  set_point(m, vert_id{1}, vec3{0, 1e307, 0});
  CHECK(dijkstra(m, vert_id{0})[vert_id{1}] == doctest::Approx(1e307));
  CHECK(spanning_tree(m).arcs.size() == num_verts(m) - 1);
}
