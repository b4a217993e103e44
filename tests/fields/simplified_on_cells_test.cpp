#include <concino/fields/simplified_on_cells.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/core/error.hpp>
#include <concino/fields/critical_points.hpp>
#include <concino/fields/persistence.hpp>
#include <concino/generate/subdivide_barycentric.hpp>
#include <concino/generate/torus.hpp>

#include <support/corpus.hpp>
#include <support/closed_surfaces.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class Pairs>
std::size_t count_from(const Pairs& pairs, double threshold) {
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [&](const auto& p) { return p.persistence >= threshold; }));
}

/// The claims of the header.
template<class M, class U>
void check_claims(const M& m, const U& u, double threshold, bool of_closed_triangles) {
  const auto g = simplified_on_cells(m, u, {.below = threshold});
  const double allowed = threshold / 2 + 1e-11;
  for (const auto v : verts(m)) CHECK(std::abs(g[v] - u[v]) <= allowed);
  const auto largest = [&](const auto& some) {
    double x = -std::numeric_limits<double>::infinity();
    for (const auto v : some) x = std::max(x, u[v]);
    return x;
  };
  for (const auto e : edges(m)) CHECK(std::abs(g[e] - largest(adj_e2v(m, e))) <= allowed);
  for (const auto p : polys(m)) CHECK(std::abs(g[p] - largest(adj_p2v(m, p))) <= allowed);

  const auto pairs = persistence(m, u);
  CHECK(g.count[0] == count_from(pairs.minima, threshold));
  if (of_closed_triangles) CHECK(g.count[2] == count_from(pairs.maxima, threshold));

  const trimesh cells = subdivide_barycentric(m);  // verts, edges, polys, in this order
  std::vector<double> values;
  for (const auto v : verts(m)) values.push_back(g[v]);
  for (const auto e : edges(m)) values.push_back(g[e]);
  for (const auto p : polys(m)) values.push_back(g[p]);
  REQUIRE(values.size() == num_verts(cells));
  auto w = make_vert_map<double>(cells);
  for (const auto v : verts(cells)) w[v] = values[v.raw()];
  const auto critical = critical_points(cells, w);
  CHECK(critical.count == std::array<std::size_t, 4>{g.count[0], g.count[1], g.count[2], 0});
  const auto left = persistence(cells, w);
  CHECK(left.minima.size() == g.count[0]);
}

}  // namespace

TEST_CASE("simplified_on_cells: both sorts of extrema go at once, and values change by at most half of the threshold, on closed surfaces") {
  std::mt19937 random(1);
  const auto check = [&](const auto& m, bool of_triangles) {
    for (unsigned round = 0; round < (long_run() ? 100u : 5u); ++round) {
      auto u = make_vert_map<double>(m);
      for (const auto v : verts(m)) u[v] = round % 2 ? static_cast<double>(random() % 9) : std::ldexp(static_cast<double>(random()), -29);
      for (const double threshold : {1e-3, 1.0, 4.0, 100.0, std::numeric_limits<double>::infinity()}) {
        if (threshold < 50) check_claims(m, u, threshold, of_triangles);
        else CHECK(simplified_on_cells(m, u, {.below = threshold}).count[0] == 1);
      }
    }
  };
  check(make_torus<trimesh>({.cells = {12, 8}}), true);
  check(quadmesh(voxel_skin({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, 1}})), false);
}

TEST_CASE("simplified_on_cells: the same on open surfaces, in parts, and with verts of no poly") {
  std::mt19937 random(2);
  const polygonmesh m(two_grids_arrays<polygonmesh>(3));
  for (unsigned round = 0; round < 10; ++round) {
    auto u = make_vert_map<double>(m);
    for (const auto v : verts(m)) u[v] = round % 2 ? static_cast<double>(random() % 9) : std::ldexp(static_cast<double>(random()), -29);
    for (const double threshold : {0.1, 1.0, 3.0}) {
      const auto g = simplified_on_cells(m, u, {.below = threshold});
      CHECK(g.count[0] + g.count[2] == g.count[1] + 3);  // two disks and a vert
      CHECK(g.count[0] == count_from(persistence(m, u).minima, threshold));
    }
  }
  const trimesh one(triangle_grid(5));
  for (unsigned round = 0; round < 5; ++round) {
    auto u = make_vert_map<double>(one);
    for (const auto v : verts(one)) u[v] = std::ldexp(static_cast<double>(random()), -29);
    for (const double threshold : {0.5, 2.0}) check_claims(one, u, threshold, false);
  }
}

TEST_CASE("simplified_on_cells: archetypes and empty meshes; edges with three polys, thresholds and values are refused") {
  const auto m = grid<trimesh>(3);
  const auto archetype = only_surface_mesh(m);
  auto u = make_vert_map<double>(archetype);
  double next = 0;
  for (const auto v : verts(archetype)) u[v] = std::sin(++next);
  CHECK(simplified_on_cells(archetype, u, {.below = 100}).count == std::array<std::size_t, 3>{1, 0, 0});
  const trimesh none;
  CHECK(simplified_on_cells(none, make_vert_map<double>(none), {.below = 1}).count == std::array<std::size_t, 3>{});
  const polygonmesh fan({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  CHECK_THROWS_WITH_AS(simplified_on_cells(fan, make_vert_map<double>(fan), {.below = 1}), doctest::Contains("has more than two polys"), unsupported);
  auto wrong = make_vert_map<double>(m);
  CHECK_THROWS_WITH_AS(simplified_on_cells(m, wrong, {}), doctest::Contains("below is 0; it must be above 0"), invalid_argument);
  CHECK_THROWS_AS(simplified_on_cells(m, wrong, {.below = std::nan("")}), invalid_argument);
  wrong[vert_id{3}] = std::nan("");
  CHECK_THROWS_WITH_AS(simplified_on_cells(m, wrong, {.below = 1}), doctest::Contains("the value at vert 3 is not finite"), invalid_argument);
}
