#include <concino/graph/min_cut.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views.hpp>

#include <support/kinds.hpp>
#include <support/random_graph.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr auto one = [](const auto&, const auto&) { return 1.0; };

/// Capacities that differ with the direction: 0, 1 ... 6 halves.
constexpr auto uneven = [](vert_id a, vert_id b) { return static_cast<double>((5 * a.raw() + 11 * b.raw()) % 13 / 2) / 2; };

/// The capacity from the nodes whose bits are set to the others.
double capacity_of_side(const list_graph& g, unsigned side) {
  double sum = 0;
  for (const vert_id a : g.nodes)
    for (const vert_id b : g.neighbours[a.raw()])
      if ((side >> a.raw() & 1) && !(side >> b.raw() & 1)) sum += uneven(a, b);
  return sum;
}

}  // namespace

TEST_CASE("min_cut: equals brute force on random graphs, and is the smallest of equals") {
  std::mt19937 random(54);
  for (int round = 0; round < 100; ++round) {
    const unsigned n = 4 + static_cast<unsigned>(random() % 5);
    const list_graph g = random_graph(random, n, 30 + static_cast<unsigned>(random() % 60));
    const std::vector<vert_id> sources = {vert_id{0}, vert_id{1}}, sinks = {vert_id{n - 1}};
    double smallest = infinity;
    unsigned fewest = 0;
    for (unsigned side = 0; side < 1u << n; ++side) {
      if ((side & 3) != 3 || (side >> (n - 1) & 1)) continue;
      const double c = capacity_of_side(g, side);
      const auto size = [](unsigned s) { return __builtin_popcount(s); };
      if (c < smallest || (c == smallest && size(side) < size(fewest))) {
        smallest = c;
        fewest = side;
      }
    }
    const auto cut = min_cut(g, sources, sinks, uneven);
    REQUIRE(cut.capacity == smallest);
    for (const vert_id v : g.nodes) REQUIRE(cut.on_source_side[v] == (fewest >> v.raw() & 1));
    double sum = 0;
    for (const auto& [a, b] : cut.arcs) {
      CHECK(cut.on_source_side[a]);
      CHECK(!cut.on_source_side[b]);
      sum += uneven(a, b);
    }
    CHECK(sum == smallest);
  }
}

TEST_CASE_TEMPLATE("min_cut: runs on meshes and on the archetypes of graphs", M, CONCINO_KINDS) {
  const M m = grid<M>(3);
  const auto g = only_primal_graph(m);
  const auto d = only_dual_graph(m);
  const vert_id v{0}, w{static_cast<unsigned>(num_verts(m) - 1)};
  const auto cut = min_cut(m, v, w, one);
  const auto bare = min_cut(g, g.vert(v), g.vert(w), one);
  CHECK(cut.capacity == bare.capacity);
  CHECK(cut.arcs.size() == static_cast<std::size_t>(cut.capacity));
  for (const auto x : verts(g)) CHECK(bare.on_source_side[x] == cut.on_source_side[g.base(x)]);

  const poly_id p{0}, q{static_cast<unsigned>(num_polys(m) - 1)};
  const auto cells = min_cut(m, {p}, {q}, one);
  CHECK(cells.capacity == min_cut(d, {d.poly(p)}, {d.poly(q)}, one).capacity);
  CHECK(cells.capacity == min_cut(dual(m), std::vector{p, p}, q, one).capacity);
  CHECK(cells.on_source_side[p]);
  CHECK(!cells.on_source_side[q]);
}

TEST_CASE("min_cut: capacities may be infinite, tiny or huge, and nodes unconnected") {
  const auto m = grid<quadmesh>(4);
  const poly_id first{0}, last{15};
  const auto column = [](poly_id p) { return p.raw() % 4; };
  std::vector<poly_id> left, right;
  for (const poly_id p : polys(m)) (column(p) == 0 ? left : right).push_back(p);
  std::erase_if(right, [&](poly_id p) { return column(p) < 3; });
  // Only the arcs between columns 1 and 2 are finite, so the cut is there.
  for (const double c : {1.0, 1e-300, 1e300, 0.1}) {
    const auto cut = min_cut(m, left, right, [&](poly_id a, poly_id b) { return column(a) + column(b) == 3 ? c : infinity; });
    CHECK(cut.arcs.size() == 4);
    CHECK(cut.capacity == c + c + c + c);
    for (const poly_id p : polys(m)) CHECK(cut.on_source_side[p] == (column(p) < 2));
  }
  CHECK(min_cut(m, first, last, [](auto, auto) { return 0; }).capacity == 0);
  const auto two = two_grids<quadmesh>(1);
  const auto apart = min_cut(two, poly_id{0}, poly_id{1}, [](auto, auto) { return infinity; });
  CHECK(apart.arcs.empty());
  CHECK(apart.on_source_side[poly_id{0}]);
  CHECK(!apart.on_source_side[poly_id{1}]);
}

TEST_CASE("min_cut: scales exactly by powers of two") {
  const auto m = grid<trimesh>(4);
  const auto cost = [](double scale) { return [=](vert_id a, vert_id b) { return scale * std::sqrt(1.0 + a.raw() * b.raw() % 7); }; };
  const auto cut = min_cut(m, vert_id{0}, vert_id{24}, cost(1)), large = min_cut(m, vert_id{0}, vert_id{24}, cost(1024));
  CHECK(large.capacity == 1024 * cut.capacity);
  CHECK(large.scale_exponent == cut.scale_exponent - 10);
  CHECK(large.arcs == cut.arcs);
}

TEST_CASE("min_cut: throws if an argument is invalid") {
  const auto m = grid<trimesh>(2);
  const vert_id a{0}, b{8};
  CHECK_THROWS_WITH_AS(min_cut(m, vert_id{9}, b, one), "min_cut: the source is not a vert of the mesh; take one from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(min_cut(m, a, vert_id{9}, one), "min_cut: the sink is not a vert of the mesh; take one from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(min_cut(m, std::vector<vert_id>{}, b, one), "min_cut: there is no source; give at least one vert", invalid_argument);
  CHECK_THROWS_WITH_AS(min_cut(m, a, std::vector<vert_id>{}, one), "min_cut: there is no sink; give at least one vert", invalid_argument);
  CHECK_THROWS_WITH_AS(min_cut(m, {a, b}, {b}, one), "min_cut: vert 8 is a source and a sink; no cut separates it from itself", invalid_argument);
  CHECK_THROWS_WITH_AS(min_cut(m, a, b, [](auto, auto) { return -2.0; }),
                       doctest::Contains("is -2; capacities must be 0 or more; +inf keeps two nodes together"), invalid_mesh);
  CHECK_THROWS_WITH_AS(min_cut(m, a, b, [](auto, auto) { return std::nan(""); }), doctest::Contains("min_cut: the capacity from vert 0 to vert "),
                       invalid_mesh);
  CHECK_THROWS_WITH_AS(min_cut(m, a, b, [](auto, auto) { return infinity; }),
                       "min_cut: arcs of infinite capacity lead from a source to the sink vert 8, so that every cut has infinite capacity; make one of them finite",
                       invalid_argument);
}
