#include <concino/geometry/enclosing_ball.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/polygons.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

/// The smallest ball, of all those that two, three or four points determine.
double smallest_radius(const std::vector<vec3>& x) {
  double best = std::numeric_limits<double>::infinity();
  const auto consider = [&](const vec3& c) {
    double r = 0;
    for (const vec3& y : x) r = std::max(r, norm(y - c));
    best = std::min(best, r);  // any centre gives a ball around all points
  };
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = i; j < x.size(); ++j) {
      consider((x[i] + x[j]) / 2);
      for (std::size_t k = j + 1; k < x.size(); ++k) {
        const vec3 b = x[j] - x[i], c = x[k] - x[i], n = cross(b, c);
        if (!(norm(n) > 0)) continue;
        consider(x[i] + (dot(c, c) * cross(n, b) + dot(b, b) * cross(c, n)) / (2 * dot(n, n)));
        for (std::size_t l = k + 1; l < x.size(); ++l) {
          const vec3 d = x[l] - x[i];
          if (const double det = dot(b, cross(c, d)); det != 0) consider(x[i] + (dot(b, b) * cross(c, d) + dot(c, c) * cross(d, b) + dot(d, d) * cross(b, c)) / (2 * det));
        }
      }
    }
  return best;
}

void check_ball(const std::vector<vec3>& points) {
  const auto ball = enclosing_ball(points);
  for (const vec3& x : points) CHECK(norm(x - ball.centre) <= ball.radius * (1 + 1e-15));
  CHECK(ball.radius == doctest::Approx(smallest_radius(points)).epsilon(1e-12));
}

}  // namespace

TEST_CASE("enclosing_ball: equals brute force on random points, in space, in planes, on lines and lattices") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::uniform_int_distribution<int> lattice(0, 2);
  for (int round = 0; round < (long_run() ? 2000 : 200); ++round) {
    std::vector<vec3> x;
    for (int i = 0; i < 1 + round % 10; ++i) {
      const double a = coordinate(random), b = coordinate(random), c = coordinate(random);
      if (round % 4 == 0) x.push_back({a, b, c});
      if (round % 4 == 1) x.push_back(a * vec3{1, 2, 3} + b * vec3{-1, 0, 2} + vec3{0, 0, 5});
      if (round % 4 == 2) x.push_back(a * vec3{3, 1, 2});
      if (round % 4 == 3) x.push_back({lattice(random), lattice(random), lattice(random)});
    }
    check_ball(x);
  }
}

TEST_CASE("enclosing_ball: closed forms") {
  std::vector<vec3> cube;
  for (int i = 0; i < 64; ++i) cube.push_back({i % 4, i / 4 % 4, i / 16});
  const auto ball = enclosing_ball(cube);
  CHECK(ball.radius == doctest::Approx(1.5 * std::sqrt(3.0)).epsilon(1e-14));
  CHECK(norm(ball.centre - vec3{1.5, 1.5, 1.5}) < 1e-14);
  CHECK(enclosing_ball(std::vector<vec3>{{1, 2, 3}, {1, 2, 3}}).radius == 0);
  CHECK(enclosing_ball(std::vector<vec3>{}).radius == -1);
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  std::vector<vec3> sphere;
  for (int i = 0; i < 20000; ++i) {
    const vec3 x{normal(random), normal(random), normal(random)};
    sphere.push_back(x / norm(x));
  }
  CHECK(enclosing_ball(sphere).radius == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("enclosing_circle: of polygons in any plane") {
  for (const std::size_t n : std::vector<std::size_t>{3, 4, 7, 100}) {
    auto x = regular_polygon(n);
    CHECK(enclosing_circle(x).radius == doctest::Approx(1).epsilon(1e-14));
    CHECK(norm(enclosing_circle(x).normal - vec3{0, 0, 1}) < 1e-14);
    for (vec3& y : x) y = rotated(y + vec3{0, 0, 2});
    CHECK(enclosing_circle(x).radius == doctest::Approx(1).epsilon(1e-13));
    CHECK(norm(enclosing_circle(x).centre - rotated(vec3{0, 0, 2})) < 1e-13);
  }
  CHECK(enclosing_circle(comb_polygon(4, 3)).radius == doctest::Approx(std::hypot(7, 4) / 2).epsilon(1e-14));
  CHECK(enclosing_circle(star_polygon(6, 0.2)).radius == doctest::Approx(1).epsilon(1e-14));
  CHECK(enclosing_circle(spiral_polygon(2)).radius == doctest::Approx(1.25 * std::sqrt(2.0)).epsilon(1e-14));
  CHECK(enclosing_circle(spiral_polygon(3)).radius == doctest::Approx(std::hypot(4.5, 3) / 2).epsilon(1e-14));
  // The distances are those of the projections, and without area those in space.
  CHECK(enclosing_circle(std::vector<vec3>{{0, 0, 1}, {2, 0, -1}, {2, 2, 1}, {0, 2, -1}}).radius == doctest::Approx(std::sqrt(2.0)));
  CHECK(enclosing_circle(std::vector<vec3>{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}).radius == 1);
  std::mt19937 random(9);
  for (int round = 0; round < (long_run() ? 10000 : 200); ++round) {
    const auto x = random_polygon(random, 3 + static_cast<std::size_t>(round % 8));
    CHECK(enclosing_circle(x).radius == doctest::Approx(smallest_radius(x)).epsilon(1e-12));
  }
}

TEST_CASE_TEMPLATE("enclosing_ball: of meshes and their polys, on archetypes, at any scale", M, CONCINO_ALL_KINDS) {
  const M m(grid_arrays<M>(3));
  const auto g = only_embedded_mesh(m);
  const auto all = enclosing_ball(m);
  CHECK(all.radius == doctest::Approx(dimension_v<M> == 2 ? std::sqrt(0.5) : std::sqrt(0.75)).epsilon(1e-14));
  CHECK(enclosing_ball(g).centre == all.centre);
  for (const double scale : {0x1p-1000, 0x1p900}) {
    const M s(scaled(grid_arrays<M>(3), scale));
    CHECK(enclosing_ball(s).radius == scale * all.radius);
    for (const auto p : polys(m)) CHECK(enclosing_ball(s, p).radius == scale * enclosing_ball(m, p).radius);
  }
  for (const auto p : polys(m)) {
    CHECK(enclosing_ball(g, g.poly(p)).radius == enclosing_ball(m, p).radius);
    if constexpr (SurfaceMesh<M>) CHECK(enclosing_circle(g, g.poly(p)).radius == doctest::Approx(enclosing_ball(m, p).radius).epsilon(1e-14));
  }
}

TEST_CASE("enclosing_ball: points that are not finite are refused by number") {
  const std::vector<vec3> x{{0, 0, 0}, {1, std::numeric_limits<double>::infinity(), 0}, {0, 1, 0}};
  CHECK_THROWS_WITH_AS((void)enclosing_ball(x), "enclosing_ball: point 1 is not finite; leave it out", invalid_argument);
  CHECK_THROWS_WITH_AS((void)enclosing_circle(x), "enclosing_circle: point 1 is not finite; leave it out", invalid_argument);
}
