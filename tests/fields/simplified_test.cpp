#include <concino/fields/simplified.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/fields/persistence.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/random_meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The claims of the header for one sort of extrema. sign: 1 for minima, -1 for maxima.
template<class M, class U>
void check_claims(const M& m, const U& u, double threshold, bool of_maxima) {
  const double sign = of_maxima ? -1 : 1;
  simplify_options options;
  (of_maxima ? options.maxima_below : options.minima_below) = threshold;
  const auto simple = simplified(m, u, options);
  for (const auto v : verts(m)) {
    const double change = sign * (simple[v] - u[v]);
    CHECK(change >= 0);
    CHECK(change < threshold + 1e-12);
  }
  const auto all = persistence(m, u), left = persistence(m, simple);
  const auto& before = of_maxima ? all.maxima : all.minima;
  const auto& after = of_maxima ? left.maxima : left.minima;
  std::vector<std::size_t> kept, found;
  for (const auto& p : before)
    if (p.persistence >= threshold) {
      kept.push_back(index_of(m, p.extremum));
      CHECK(simple[p.extremum] == u[p.extremum]);
      const auto same = std::find_if(after.begin(), after.end(), [&](const auto& q) { return q.extremum == p.extremum; });
      REQUIRE(same != after.end());
      if (p.saddle) CHECK(std::abs(same->persistence - p.persistence) < 1e-12);
      else CHECK(!same->saddle);
    }
  for (const auto& p : after) found.push_back(index_of(m, p.extremum));
  std::sort(kept.begin(), kept.end());
  std::sort(found.begin(), found.end());
  CHECK(kept == found);
  const auto again = simplified(m, simple, options);
  for (const auto v : verts(m)) CHECK(again[v] == simple[v]);
}

}  // namespace

TEST_CASE_TEMPLATE("simplified: small extrema go, the others keep their values, u changes by less than the threshold", M, polygonmesh, tetmesh) {
  std::mt19937 random(1);
  const unsigned rounds = num_random_meshes() / 4;
  for (unsigned round = 0; round < rounds; ++round) {
    CAPTURE(round);
    const M m = round % 4 == 0 ? grid<M>(3) : random_mesh<M>(random);
    auto u = make_vert_map<double>(m);
    for (const auto v : verts(m)) u[v] = round % 2 ? static_cast<double>(random() % 9) : std::ldexp(static_cast<double>(random()), -29);
    for (const double threshold : {0.5, 1.0, 3.0})
      for (const bool of_maxima : {false, true}) check_claims(m, u, threshold, of_maxima);
  }
}

TEST_CASE("simplified: a shallow valley is filled up to its pass, a deep one stays, and so do verts elsewhere") {
  const auto m = grid<quadmesh>(6);  // points (i, j) / 6 at vert 7 j + i
  const double profile[] = {0, 4, 2, 4.5, 1, 5, 6};
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = profile[v.raw() % 7];
  const auto simple = simplified(m, u, {.minima_below = 3});
  for (const auto v : verts(m)) CHECK(simple[v] == doctest::Approx(v.raw() % 7 == 2 ? 4 : u[v]).epsilon(1e-14));
  const auto none = simplified(m, u, {.minima_below = std::numeric_limits<double>::infinity()});
  CHECK(persistence(m, none).minima.size() == 1);
  CHECK(persistence(m, simplified(m, u, {.maxima_below = 100})).maxima.size() == 1);
}

TEST_CASE("simplified: a flat function has one minimum in each component") {
  const auto m = two_grids<polygonmesh>(3);
  const auto g = only_primal_graph(m);
  const auto simple = simplified(g, make_vert_map<double>(g, 1.0), {.minima_below = 1e-9});
  CHECK(persistence(g, simple).minima.size() == 3);
  for (const auto v : verts(g)) CHECK(std::abs(simple[v] - 1) < 1e-12);
  const trimesh empty;
  CHECK(simplified(empty, make_vert_map<double>(empty), {.maxima_below = 1}).values().empty());
}

TEST_CASE("simplified: rejects thresholds out of their range, and values that are not finite") {
  const auto m = grid<trimesh>(2);
  auto u = make_vert_map<double>(m, 1.0);
  CHECK_THROWS_WITH_AS(simplified(m, u, {}), doctest::Contains("one of minima_below and maxima_below must be above 0"), invalid_argument);
  CHECK_THROWS_AS(simplified(m, u, {.minima_below = 1, .maxima_below = 1}), invalid_argument);
  CHECK_THROWS_WITH_AS(simplified(m, u, {.minima_below = -1}), doctest::Contains("minima_below is -1"), invalid_argument);
  CHECK_THROWS_WITH_AS(simplified(m, u, {.maxima_below = std::nan("")}), doctest::Contains("maxima_below is nan"), invalid_argument);
  u[vert_id{2}] = std::nan("");
  CHECK_THROWS_WITH_AS(simplified(m, u, {.minima_below = 1}), doctest::Contains("simplified: the value at vert 2 is not finite"), invalid_argument);
}
