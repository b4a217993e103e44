#include <concino/geometry/width.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/polygons.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

double extent(const std::vector<vec3>& x, const vec3& n) {
  double low = 1e300, high = -1e300;
  for (const vec3& y : x) low = std::min(low, dot(n, y)), high = std::max(high, dot(n, y));
  return (high - low) / norm(n);
}

/// By all directions in which a pair of planes around points may be.
double width_by_brute_force(const std::vector<vec3>& x) {
  double w = 1e300;
  const auto consider = [&](const vec3& n) {
    if (norm(n) > 1e-9) w = std::min(w, extent(x, n));
  };
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < x.size(); ++k)
        for (std::size_t l = 0; l < k; ++l) consider(cross(x[i] - x[j], x[k] - x[l]));
  return w;
}

polygonmesh mesh_of(const std::vector<vec3>& polygon) {
  surface_arrays s{polygon, {0, static_cast<std::uint32_t>(polygon.size())}, {}, 0};
  for (unsigned i = 0; i < polygon.size(); ++i) s.verts.push_back(vert_id{i});
  return polygonmesh(s);
}
double width_of(const std::vector<vec3>& polygon) { return width(mesh_of(polygon), poly_id{0}).width; }

}  // namespace

TEST_CASE("width: equals brute force on random points") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int round = 0; round < 60; ++round) {
    std::vector<vec3> x;
    for (int i = 0; i < 4 + round % 6; ++i) x.push_back({coordinate(random), coordinate(random), coordinate(random)});
    const auto w = width(x);
    CHECK(w.width == doctest::Approx(width_by_brute_force(x)).epsilon(1e-12));
    CHECK(extent(x, w.direction) == doctest::Approx(w.width).epsilon(1e-12));
    CHECK(norm(w.direction) == doctest::Approx(1).epsilon(1e-14));
    auto turned = x, large = x;
    for (vec3& y : turned) y = rotated(y);
    for (vec3& y : large) y *= 0x1p500;
    CHECK(width(turned).width == doctest::Approx(w.width).epsilon(1e-12));
    CHECK(width(large).width == 0x1p500 * w.width);
  }
}

TEST_CASE("width: closed forms of polygons and polyhedra") {
  for (const std::size_t n : std::vector<std::size_t>{3, 4, 5, 6, 7, 100, 101}) {
    const double half = std::numbers::pi / static_cast<double>(n);
    CHECK(width_of(regular_polygon(n)) == doctest::Approx(n % 2 == 0 ? 2 * std::cos(half) : 1 + std::cos(half)).epsilon(1e-13));
  }
  for (const std::size_t n : std::vector<std::size_t>{2, 3, 8}) CHECK(width_of(comb_polygon(n, 2)) == 3);
  CHECK(width_of(star_polygon(5, 0.3)) == doctest::Approx(1 + std::cos(std::numbers::pi / 5)).epsilon(1e-13));
  CHECK(width_of(star_polygon(8, 0.3)) == doctest::Approx(2 * std::cos(std::numbers::pi / 8)).epsilon(1e-13));
  CHECK(width_of(spiral_polygon(2)) == doctest::Approx(3.5 / std::sqrt(2.0)).epsilon(1e-13));  // an L
  CHECK(width_of(spiral_polygon(3)) == 3);
  // A regular tet with edges of length 1: between two opposite edges.
  const std::vector<vec3> tet{{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
  CHECK(width(tet).width == doctest::Approx(1).epsilon(1e-14));
  std::vector<vec3> box{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {3, 2, 0}, {0, 0, 1}, {3, 0, 1}, {0, 2, 1}, {3, 2, 1}};
  CHECK(width(box).width == 1);
  CHECK(std::abs(width(box).direction.z) == 1);
}

TEST_CASE("width: of polygons, by all directions of two corners, in any plane") {
  std::mt19937 random(12);
  for (int round = 0; round < (long_run() ? 10000 : 300); ++round) {
    auto x = random_polygon(random, 3 + static_cast<std::size_t>(round % 9));
    double expected = 1e300;
    for (const vec3& a : x)
      for (const vec3& b : x)
        if (!(a == b)) expected = std::min(expected, extent(x, {a.y - b.y, b.x - a.x, 0}));
    CHECK(width_of(x) == doctest::Approx(expected).epsilon(1e-12));
    for (vec3& y : x) y = rotated(y + vec3{0, 0, 4});
    const auto w = width(mesh_of(x), poly_id{0});
    CHECK(w.width == doctest::Approx(expected).epsilon(1e-11));
    CHECK(extent(x, w.direction) == doctest::Approx(w.width).epsilon(1e-12));
  }
}

TEST_CASE("width: of less than three dimensions") {
  CHECK(norm(width(std::vector<vec3>{}).direction) == 0);
  for (const auto& x : std::vector<std::vector<vec3>>{{{1, 2, 3}}, {{0, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}) {
    const auto w = width(x);
    CHECK(w.width == 0);
    CHECK(norm(w.direction) == doctest::Approx(1));
    CHECK(extent(x, w.direction) < 1e-15);
  }
  CHECK(width_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}) == 0);
  CHECK_THROWS_AS((void)width(std::vector<vec3>{{0, 0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}}), invalid_argument);
}

TEST_CASE_TEMPLATE("width: of polys of meshes, on archetypes too", M, CONCINO_ALL_KINDS) {
  const M m(grid_arrays<M>(2));
  const auto g = only_embedded_mesh(m);
  for (const auto p : polys(m)) {
    CHECK(width(m, p).width > 0.1);
    CHECK(width(m, p).width <= 1);
    CHECK(width(g, g.poly(p)).width == width(m, p).width);
  }
}
