#include <concino/fields/regions_of_maxima.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/fields/persistence.hpp>
#include <concino/fields/simplified.hpp>

#include <support/kinds.hpp>
#include <support/random_meshes.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("regions_of_maxima: one region for each maximum, and each vert has the label of its highest neighbour", M, polygonmesh, tetmesh) {
  std::mt19937 random(1);
  for (unsigned round = 0; round < 30; ++round) {
    const M m = random_mesh<M>(random);
    auto u = make_vert_map<double>(m), minus = u;
    for (const auto v : verts(m)) u[v] = static_cast<double>(random() % 9);
    const auto regions = regions_of_maxima(m, u);
    CHECK(regions.extrema.size() == persistence(m, u).maxima.size());
    for (const auto v : verts(m)) {
      auto highest = v;
      for (const auto w : adj_v2v(m, v))
        if (u[w] > u[highest] || (u[w] == u[highest] && w.raw() > highest.raw())) highest = w;
      CHECK(regions[v] == regions[highest]);
      if (highest == v) CHECK(regions.extrema[static_cast<std::size_t>(regions[v])] == v);
    }
    CHECK(regions_of_minima(m, u).extrema.size() == persistence(m, u).minima.size());
    for (std::size_t i = 1; i < regions.extrema.size(); ++i) CHECK(u[regions.extrema[i - 1]] >= u[regions.extrema[i]]);
  }
}

TEST_CASE("regions_of_maxima: two hills share a square at the valley between them") {
  const auto m = grid<trimesh>(8);
  const auto g = only_primal_graph(m);
  auto u = make_vert_map<double>(g);
  for (const auto v : verts(g)) {
    const vec3 x = to_vec3(point(m, vert_id(static_cast<unsigned>(index_of(g, v)))));
    u[v] = -std::abs(std::abs(x.x - 0.5) - 0.25) - 0.1 * std::abs(x.y - 0.5) + 0.01 * x.x;
  }
  const auto regions = regions_of_maxima(g, u);
  REQUIRE(regions.extrema.size() == 2);
  for (const auto v : verts(g)) {
    const double x = to_vec3(point(m, vert_id(static_cast<unsigned>(index_of(g, v))))).x;
    if (x < 0.4 || x > 0.6) CHECK(regions[v] == (x < 0.5 ? 1 : 0));
  }
  CHECK(regions_of_maxima(g, simplified(g, u, {.maxima_below = 0.5})).extrema.size() == 1);
  const trimesh none;
  CHECK(regions_of_minima(none, make_vert_map<double>(none)).extrema.empty());
  auto wrong = make_vert_map<double>(m);
  wrong[vert_id{1}] = std::nan("");
  CHECK_THROWS_WITH_AS(regions_of_maxima(m, wrong), doctest::Contains("regions_of_maxima: the value at vert 1 is not finite"), invalid_argument);
  CHECK_THROWS_AS(regions_of_minima(m, wrong), invalid_argument);
}
