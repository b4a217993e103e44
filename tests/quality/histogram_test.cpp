// histogram: each poly is counted once, in the right bin.
#include <concino/quality.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/generators.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace cn = concino;
using cn::metric;
using counts = std::vector<std::size_t>;

TEST_CASE_TEMPLATE("histogram: counts all polys, the same on the archetype", M, CONCINO_KINDS) {
  const M m(cn::testing::jittered(cn::testing::grid_arrays<M>(3), 0.1));
  const auto h = cn::histogram(m, metric::mean_ratio, {.bins = 7});
  CHECK(std::accumulate(h.counts.begin(), h.counts.end(), std::size_t{0}) == cn::num_polys(m));
  CHECK(h.counts.front() > 0);
  CHECK(h.counts.back() > 0);
  CHECK(h.below + h.above + h.undefined == 0);
  const auto values = cn::quality(m, metric::mean_ratio);
  double sum = 0;
  for (const auto p : cn::polys(m)) {
    sum += values[p];
    CHECK((h.min_value <= values[p] && values[p] <= h.max_value));
  }
  CHECK(h.mean == doctest::Approx(sum / static_cast<double>(cn::num_polys(m))));
  const auto g = cn::only_embedded_mesh(m);
  CHECK(cn::histogram(g, metric::mean_ratio, {.bins = 7}).counts == h.counts);
}

TEST_CASE("histogram: bins, infinite values, and polys that a solver may not like") {
  // right triangles with legs 1 and 1, 2, 3; one without area; one with a point that is not finite
  const cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}, {2, 0, 0}, {std::numeric_limits<double>::infinity(), 0, 0}},
                      {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}, {0, 1, 6}});
  auto h = cn::histogram(m, metric::area, {.bins = 3, .low = 0, .high = 1.5});
  CHECK(h.counts == counts{1, 1, 2});  // 0, 0.5, 1 and 1.5
  CHECK(h.undefined == 1);
  CHECK(h.unacceptable == 1);
  CHECK(h.start_of(1) == 0.5);
  h = cn::histogram(m, metric::aspect_frobenius, {.bins = 2, .low = 1, .high = 1.2});
  CHECK(h.counts == counts{0, 1});  // legs 1 and 1: 2 / sqrt(3)
  CHECK(h.above == 3);
  CHECK(h.unacceptable == 4);
  h = cn::histogram(m, metric::minimum_angle, {.bins = 4, .low = 20});
  CHECK(h.below == 2);  // 0 degrees and atan(1/3)
  CHECK(h.high == doctest::Approx(45));
  CHECK(h.counts == counts{0, 1, 0, 1});
}

TEST_CASE("histogram: equal values, no polys, errors") {
  const auto same = cn::histogram(cn::testing::grid<cn::quadmesh>(2), metric::skew, {.bins = 3});
  CHECK(same.counts == counts{4, 0, 0});
  const auto none = cn::histogram(cn::tetmesh(), metric::volume);
  CHECK(none.counts == counts(10));
  CHECK((none.min_value == 0 && none.max_value == 0 && none.mean == 0));
  const cn::tetmesh m = cn::testing::grid<cn::tetmesh>(1);
  CHECK_THROWS_AS(cn::histogram(m, metric::volume, {.bins = 0}), cn::invalid_argument);
  CHECK_THROWS_AS(cn::histogram(m, metric::volume, {.low = 2, .high = 1}), cn::invalid_argument);
  CHECK_THROWS_AS(cn::histogram(m, metric::volume, {.high = std::numeric_limits<double>::infinity()}), cn::invalid_argument);
  CHECK_THROWS_AS(cn::histogram(m, metric::oddy), cn::unsupported);
}

TEST_CASE("quality: the calls of docs/quality.md") {
  const cn::tetmesh m = cn::testing::grid<cn::tetmesh>(2);
  const cn::poly_id p{0};
  //! [calls]
  double q = cn::scaled_jacobian(m, p);                        // of one poly
  auto map = cn::quality(m, cn::metric::mean_ratio);           // of all: map[p]
  auto w = cn::worst(m, cn::metric::aspect_ratio);             // w.poly, w.value
  auto h = cn::histogram(m, cn::metric::minimum_angle);        // h.counts, h.unacceptable
  bool fine = cn::is_acceptable(cn::metric::edge_ratio, cn::poly_shape::tet, 2.5);
  //! [calls]
  CHECK(q == doctest::Approx(1 / std::sqrt(3.0)));  // each corner of a tet of the grid has edges along axes and diagonals
  CHECK(map[p] == cn::mean_ratio(m, p));
  CHECK(w.value == cn::quality(m, w.poly, metric::aspect_ratio));
  CHECK(h.unacceptable == 0);
  CHECK(fine);
}
