#include <concino/print/heights.hpp>

#include <concino/core/error.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("heights: steps from the bottom to below the top", M, CONCINO_ALL_VOLUME_KINDS) {
  const M m = grid<M>(2);
  CHECK(heights(m, 0.25) == std::vector<double>{0, 0.25, 0.5, 0.75});
  CHECK(heights(m, 0.1).size() == 10);  // 10 * 0.1 is 1 up to rounding
  CHECK(heights(m, 0.3).size() == 4);
  CHECK(heights(m, 5) == std::vector<double>{0});
}

TEST_CASE_TEMPLATE("heights: a flat mesh has none", M, CONCINO_SURFACE_KINDS) { CHECK(heights(grid<M>(2), 0.25).empty()); }

TEST_CASE("heights: wrong thickness, and verts that are not finite") {
  const auto m = grid<tetmesh>(1);
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double t : {0.0, -1.0, infinite, std::numeric_limits<double>::quiet_NaN(), 1e-12}) CHECK_THROWS_AS((void)heights(m, t), invalid_argument);
  auto a = grid_arrays<tetmesh>(1);
  a.points[0].z = infinite;
  CHECK_THROWS_AS((void)heights(tetmesh(a), 0.1), invalid_mesh);
  CHECK(heights(tetmesh(), 1).empty());
}
