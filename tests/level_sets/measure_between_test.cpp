#include <concino/level_sets/measure_between.hpp>

#include <concino/core/error.hpp>
#include <concino/level_sets/clip.hpp>

#include <support/kinds.hpp>
#include <support/level_sets.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("measure_between: equals the measures of the clips, and sums to the whole", M, CONCINO_KINDS) {
  std::mt19937 random(1);
  for (int i = 0; i < 15; ++i) {
    const M m = mesh_to_cut<M>(random);
    const auto u = random_values(m, random, i % 2 == 0);
    const double whole = total_measure(m);
    const std::vector<double> values{0, 0.5, 1, 1.3, 2};
    const auto between = measure_between(m, u, values);
    REQUIRE(between.size() == 4);
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const double above = k < 3 ? values[k + 1] : std::nextafter(2.0, 3.0);  // the last interval is closed
      const double difference = total_measure(clip(m, u, values[k]).mesh) - total_measure(clip(m, u, above).mesh);
      CHECK(std::abs(between[k] - difference) <= 1e-12 * whole);
      sum += between[k];
    }
    CHECK(std::abs(sum - whole) <= 1e-12 * whole);
  }
}

TEST_CASE_TEMPLATE("measure_between: layers of a box", M, CONCINO_KINDS) {
  const M m = make_grid<M>({.cells = {3, 5, 2}});
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = point(m, v).x;
  const auto layers = measure_between(m, u, {0.75, 0.0, 0.1, 1.0, 0.1});
  REQUIRE(layers.size() == 3);
  CHECK(layers[0] == doctest::Approx(0.1).epsilon(1e-13));
  CHECK(layers[1] == doctest::Approx(0.65).epsilon(1e-13));
  CHECK(layers[2] == doctest::Approx(0.25).epsilon(1e-13));
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(measure_between(m, u, {-infinite, infinite}).at(0) == doctest::Approx(1).epsilon(1e-13));
}

TEST_CASE_TEMPLATE("measure_between: the same for any number of threads, also where neighbours are cut apart from each other", M, trimesh, tetmesh, polyhedralmesh) {
  const unsigned n = dimension_v<M> == 2 ? 40 : 12;
  const M m = make_grid<M>({.cells = {n, n, dimension_v<M> == 2 ? 1 : n}});
  std::mt19937 random(4);
  const auto u = random_values(m, random, true);  // nearly all polys are cut, in many parts
  const auto with = [&](int threads) {
    const with_num_threads fixed(threads);
    return measure_between(m, u, {0.0, 0.7, 1.0, 2.0});
  };
  const auto one = with(1);
  CHECK(one == with(2));
  CHECK(one == with(3));
  double sum = 0;
  for (const double x : one) sum += x;
  CHECK(std::abs(sum - 1) <= 1e-12);
  CHECK(std::abs(one[1] - (total_measure(clip(m, u, 0.7).mesh) - total_measure(clip(m, u, 1.0).mesh))) <= 1e-12);
}

TEST_CASE_TEMPLATE("measure_between: polys can be cut one by one, also where caps of neighbours coincide", M, CONCINO_KINDS) {
  std::mt19937 random(5);
  for (int i = 0; i < 60; ++i) {
    const M m = mesh_to_cut<M>(random);
    const auto u = random_values(m, random, i % 2 == 0);
    const auto crossed = concino::detail::crossed_polys(m, concino::detail::level_states(m, u, 1, "test"));
    if (crossed.empty()) continue;
    double sum = 0;
    for (const auto p : crossed) sum += concino::detail::cut_measure_of(m, u, 1.0, std::vector{p});
    CHECK(std::abs(sum - concino::detail::cut_measure_of(m, u, 1.0, crossed)) <= 1e-12 * total_measure(m));
  }
}

TEST_CASE("measure_between: errors") {
  const auto m = make_grid<tetmesh>({.cells = {2, 2, 2}});
  auto u = make_vert_map<double>(m, 0.5);
  CHECK_THROWS_AS((void)measure_between(m, u, {0.5}), invalid_argument);
  CHECK_THROWS_AS((void)measure_between(m, u, {0.5, std::nan("")}), invalid_argument);
  const auto larger = make_grid<tetmesh>({.cells = {3, 2, 2}});
  CHECK_THROWS_AS((void)measure_between(larger, u, {0.0, 1.0}), invalid_argument);
  u[vert_id(2)] = std::nan("");
  CHECK_THROWS_AS((void)measure_between(m, u, {0.0, 1.0}), invalid_argument);
}
