#include <concino/geometry/inscribed_circle.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/polygons.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

using namespace concino;
using namespace concino::testing;

namespace {

/// The largest depth that a search from a grid of points finds.
double deepest(const std::vector<vec3>& polygon, int n) {
  double found = 0;
  vec3 low{1e300, 1e300, 0}, high = -low;
  for (const vec3& x : polygon) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y), 0};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), 0};
  }
  vec3 best;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const vec3 x{low.x + (high.x - low.x) * (i + 0.5) / n, low.y + (high.y - low.y) * (j + 0.5) / n, 0};
      if (const double d = depth_in_polygon(polygon, x); d > found) found = d, best = x;
    }
  for (double step = norm(high - low) / n; step > 1e-13; step /= 2)
    for (bool any = true; any;) {
      any = false;
      for (int k = 0; k < 16; ++k) {
        const double a = k * std::numbers::pi / 8;
        const vec3 x = best + step * vec3{std::cos(a), std::sin(a), 0};
        if (const double d = depth_in_polygon(polygon, x); d > found * (1 + 1e-12)) found = d, best = x, any = true;
      }
    }
  return found;
}

void check_circle(const std::vector<vec3>& polygon, double expected) {
  const auto c = inscribed_circle(polygon);
  CHECK(c.radius == doctest::Approx(expected).epsilon(2e-9));
  CHECK(c.max_radius >= expected * (1 - 1e-14));
  CHECK(c.radius >= (1 - 1.01e-9) * c.max_radius);
  CHECK(depth_in_polygon(polygon, c.centre) == doctest::Approx(c.radius).epsilon(1e-12));
}

}  // namespace

TEST_CASE("inscribed_circle: of regular polygons, rectangles, combs, stars and spirals") {
  for (const std::size_t n : std::vector<std::size_t>{3, 4, 5, 6, 12, 101, 1000}) check_circle(regular_polygon(n), std::cos(std::numbers::pi / static_cast<double>(n)));
  check_circle({{0, 0, 0}, {7, 0, 0}, {7, 2, 0}, {0, 2, 0}}, 1);
  check_circle({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, 1);
  // A tooth meets the bar in a T: a circle touches the bottom and the two corners beside the tooth.
  const double in_comb = 0.5 * (1 + 0.25);
  for (const std::size_t n : std::vector<std::size_t>{3, 5, 12}) check_circle(comb_polygon(n, 3), in_comb);
  // Between the inner corners of a star, where they are at a distance of less than that of the edges from the centre.
  for (const std::size_t n : std::vector<std::size_t>{5, 8, 30}) check_circle(star_polygon(n, 0.3), 0.3);
  // In a turn of the corridor, a circle touches the inner corner and both outer edges.
  for (const std::size_t n : std::vector<std::size_t>{3, 8, 21}) check_circle(spiral_polygon(n), std::sqrt(2.0) / (1 + std::sqrt(2.0)));
}

TEST_CASE("inscribed_circle: is as large as a search finds it, and as its bound says") {
  std::mt19937 random(3);
  const int rounds = long_run() ? 10000 : 400;
  double worst = 0;
  for (int round = 0; round < rounds; ++round) {
    const auto polygon = random_polygon(random, 3 + static_cast<std::size_t>(round % 11));
    const auto c = inscribed_circle(polygon);
    CHECK(depth_in_polygon(polygon, c.centre) == doctest::Approx(c.radius).epsilon(1e-9));
    CHECK(c.radius >= (1 - 1e-9) * c.max_radius - 1e-14);
    const double found = deepest(polygon, 12);
    CHECK(found <= c.max_radius + 1e-14);
    worst = std::max(worst, found - c.radius);
  }
  CHECK(worst < 1e-9);
}

TEST_CASE("inscribed_circle: moves and scales with the polygon") {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    const auto polygon = random_polygon(random, 9);
    const auto c = inscribed_circle(polygon);
    auto turned = polygon;
    for (vec3& x : turned) x = rotated(x + vec3{0, 0, 3});
    const auto d = inscribed_circle(turned);
    CHECK(d.radius == doctest::Approx(c.radius).epsilon(2e-9));
    CHECK(norm(d.normal - (rotated(vec3{0, 0, 1}) - rotated(vec3{}))) < 1e-12);
    for (const double scale : {0x1p-900, 0x1p-40, 0x1p700}) {
      auto scaled = polygon;
      for (vec3& x : scaled) x *= scale;
      const auto s = inscribed_circle(scaled);
      CHECK(s.radius == c.radius * scale);
      CHECK(s.max_radius == c.max_radius * scale);
      CHECK(s.centre == scale * c.centre);
    }
  }
}

TEST_CASE_TEMPLATE("inscribed_circle: of the polys of a mesh, and on the archetype", M, CONCINO_ALL_SURFACE_KINDS) {
  const M m(grid_arrays<M>(2));
  const auto g = only_embedded_mesh(m);
  for (const auto p : polys(m)) {
    std::vector<vec3> x;
    for (const auto v : adj_p2v(m, p)) x.push_back(point(m, v));
    const auto c = inscribed_circle(m, p);
    CHECK(c.radius == inscribed_circle(x).radius);
    CHECK(c.centre == inscribed_circle(g, g.poly(p)).centre);
  }
}

TEST_CASE("inscribed_circle: the tolerance, and a limit of the work") {
  std::mt19937 random(6);
  const auto polygon = random_polygon(random, 40);
  const auto rough = inscribed_circle(polygon, {.tolerance = 0.1}), one = inscribed_circle(polygon, {.max_parts = 1}), fine = inscribed_circle(polygon);
  CHECK(rough.radius >= 0.9 * rough.max_radius);
  CHECK(rough.max_radius >= fine.radius);
  CHECK(one.max_radius >= fine.radius);
  CHECK(one.radius <= fine.max_radius);
  // A thin polygon that is not convex, in any direction.
  std::vector<vec3> thin{{0, 0, 0}, {1, 0, 0}, {1, 1e-4, 0}, {0.5, 0.9e-4, 0}, {0, 1e-4, 0}};
  CHECK(inscribed_circle(thin).radius > 0.45e-4);
  for (vec3& x : thin) x = rotated(x);
  CHECK(inscribed_circle(thin).radius > 0.45e-4);
}

TEST_CASE("inscribed_circle: polygons without an inside are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](std::vector<vec3> polygon, const char* text) { CHECK_THROWS_WITH_AS((void)inscribed_circle(polygon), text, invalid_argument); };
  refused({{0, 0, 0}, {1, 0, 0}}, "inscribed_circle: the polygon has 2 corners; 3 are the fewest; give one that is simple, seen along its vector area");
  refused({{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}, "inscribed_circle: the polygon has a corner that is not finite, number 1; give one that is simple, seen along its vector area");
  refused({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, "inscribed_circle: the polygon has two equal corners, number 1 and the next one; give one that is simple, seen along its vector area");
  refused({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 2, 0}}, "inscribed_circle: the polygon touches itself: its edges from corners 1 and 3 meet; give one that is simple, seen along its vector area");
  refused({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0, 0}, {0, 4, 0}}, "inscribed_circle: the polygon touches itself: its edges from corners 0 and 3 meet; give one that is simple, seen along its vector area");
  CHECK_THROWS_AS((void)inscribed_circle(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}), invalid_argument);
  const polygonmesh m({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 2, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_WITH_AS((void)inscribed_circle(m, poly_id{0}), "inscribed_circle: poly 0 touches itself: its edges from corners 1 and 3 meet; validate(m) finds such polys", invalid_mesh);
  for (const double t : {0.0, 1.0, -1.0, nan, 1e-13})
    CHECK_THROWS_AS((void)inscribed_circle(regular_polygon(5), {.tolerance = t}), invalid_argument);
  CHECK_THROWS_AS((void)inscribed_circle(regular_polygon(5), {.max_parts = 0}), invalid_argument);
}
