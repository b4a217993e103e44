#include <concino/render/position_criteria.hpp>

#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

#include <support/meshes.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace concino;

namespace {

template<class M, class C>
std::size_t count(const M& m, const C& criterion) {
  const auto meets = criterion.prepare(m);
  std::size_t n = 0;
  for (const auto p : polys(m)) n += meets(p);
  return n;
}

const double not_a_number = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("below, above, between: compare centroids, half-open") {
  const hexmesh m(testing::hex_grid(4));  // centroids at 1/8, 3/8, 5/8, 7/8, exactly
  for (const char axis : {'x', 'y', 'z'}) {
    CHECK(count(m, below(axis, 0.3)) == 16);
    CHECK(count(m, below(axis, 0.375)) == 16);
    CHECK(count(m, above(axis, 0.375)) == 48);
    CHECK(count(m, between(axis, 0.375, 0.875)) == 32);
    CHECK(count(m, between(axis, 0.375, 0.375)) == 0);
    CHECK(count(m, below(axis, inf)) == 64);
    CHECK(count(m, above(axis, -inf)) == 64);
    CHECK(count(m, below(axis, -inf)) == 0);
  }
  for (const auto p : polys(m)) {
    CHECK(below('y', 0.5).prepare(m)(p) == (centroid(m, p).y < 0.5));
    CHECK(below('y', 0.5).prepare(m)(p) != above('y', 0.5).prepare(m)(p));
  }
}

TEST_CASE("below, above: planes of any direction and length of normal") {
  const hexmesh m(testing::hex_grid(4));
  const plane diagonal = plane_through({0.5, 0.5, 0}, {3, 3, 0});
  CHECK(count(m, below(diagonal)) == 4 * 6);  // the four on the diagonal are on the plane
  CHECK(count(m, above(diagonal)) == 4 * 10);
  CHECK(count(m, above(plane{{0, 0, -1}, -0.5})) == count(m, below('z', 0.5)));
}

TEST_CASE("below_fraction, above_fraction: of the bounding box") {
  hexmesh m(testing::hex_grid(4));
  for (const auto v : verts(m)) set_point(m, v, 10.0 * to_vec3(point(m, v)) + vec3{-100, 0, 7});
  CHECK(count(m, below_fraction('x', 0.5)) == 32);
  CHECK(count(m, above_fraction('z', 0.25)) == 48);
  CHECK(count(m, above_fraction('z', 0)) == 64);
  CHECK(count(m, below_fraction('y', 1)) == 64);
  CHECK(count(m, above_fraction('y', 1.5)) == 0);
  CHECK(count(m, below_fraction('y', inf)) == 64);
  CHECK(count(hexmesh(), below_fraction('x', 0.5)) == 0);
}

TEST_CASE("below, above: polys without a finite centroid are neither") {
  hexmesh m(testing::hex_grid(2));
  set_point(m, *verts(m).begin(), vec3{not_a_number, 0, 0});
  CHECK(count(m, below('x', 0.5)) == 3);
  CHECK(count(m, above('x', 0.5)) == 4);
  CHECK(count(m, below(plane{{1, 0, 0}, 0.5})) + count(m, above(plane{{1, 0, 0}, 0.5})) == 7);
}

TEST_CASE("below, above: a poly that is turned over is where its verts are") {
  // Two tets with opposite orientations that share three verts: the moments of their union cancel out, but for a small rest.
  const std::vector<vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1 - 1e-9}};
  const std::vector<std::vector<unsigned>> walls{{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}};
  const std::vector<std::vector<std::pair<unsigned, bool>>> cells{{{1, true}, {2, true}, {3, true}, {4, false}, {5, false}, {6, false}}};
  const polyhedralmesh m(points, walls, cells);
  CHECK(count(m, below('x', 1.5)) == 1);
  CHECK(count(m, above('x', -0.5)) == 1);
  CHECK(count(m, above('z', 1.5)) == 0);
}

TEST_CASE("below, above, between: wrong arguments throw") {
  CHECK_THROWS_WITH_AS(below('w', 1), "below: the axis must be 'x', 'y' or 'z'", invalid_argument);
  CHECK_THROWS_AS(above(0, 1), invalid_argument);
  CHECK_THROWS_WITH_AS(below('x', not_a_number), "below: a coordinate is not a number (NaN)", invalid_argument);
  CHECK_THROWS_AS(above('x', not_a_number), invalid_argument);
  CHECK_THROWS_AS(between('x', 0, not_a_number), invalid_argument);
  CHECK_THROWS_WITH_AS(between('x', 1, 0.5), "between: the lower coordinate is above the upper one", invalid_argument);
  CHECK_THROWS_AS(below_fraction('x', not_a_number), invalid_argument);
  CHECK_THROWS_AS(above_fraction('a', 0), invalid_argument);
  CHECK_THROWS_WITH_AS(below(plane{{0, 0, 0}, 1}), "below: the plane must have a finite offset and a finite normal other than 0", invalid_argument);
  CHECK_THROWS_AS(above(plane{{0, not_a_number, 0}, 1}), invalid_argument);
  CHECK_THROWS_AS(above(plane{{0, 1, 0}, not_a_number}), invalid_argument);
}
