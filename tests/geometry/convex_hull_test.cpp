#include <concino/geometry/convex_hull.hpp>

#include <concino/geometry/measure.hpp>
#include <concino/geometry/orientation.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

using namespace concino;

namespace {

std::vector<vec3> grid_points(int n) {
  std::vector<vec3> points;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k) points.push_back({i, j, k});
  return points;
}

std::vector<vec3> random_ball(std::mt19937& random, std::size_t n, bool on_sphere) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<vec3> points;
  while (points.size() < n) {
    const vec3 x{coordinate(random), coordinate(random), coordinate(random)};
    const double r = norm(x);
    if (r > 0.1 && r < 1) points.push_back(on_sphere ? x / r : x);
  }
  return points;
}

/// Random points of small integer coordinates: many are equal, collinear or coplanar.
std::vector<vec3> random_lattice(std::mt19937& random, std::size_t n, int size) {
  std::uniform_int_distribution<int> coordinate(0, size);
  std::vector<vec3> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({coordinate(random), coordinate(random), coordinate(random)});
  return points;
}

/// The hull's laws; its volume.
double check_hull(const std::vector<vec3>& points) {
  const convex_hull_result hull = convex_hull(points);
  const polygonmesh m(hull.surface);
  REQUIRE(hull.corners.size() == num_verts(m));
  CHECK(std::is_sorted(hull.corners.begin(), hull.corners.end()));
  for (const auto v : verts(m)) CHECK(point(m, v) == points[hull.corners[v.raw()]]);
  if (hull.dimension < 2) {
    CHECK(num_polys(m) == 0);
    CHECK(num_verts(m) == static_cast<std::size_t>(hull.dimension + 1));
    return 0;
  }
  CHECK(num_verts(m) + num_polys(m) == num_edges(m) + 2);
  for (const auto e : edges(m)) CHECK(num_elements(adj_e2p(m, e)) == 2);
  double six_volumes = 0;
  std::size_t wrong = 0;
  for (const auto p : polys(m)) {
    std::vector<vec3> x;
    for (const auto v : adj_p2v(m, p)) x.push_back(point(m, v));
    REQUIRE(x.size() >= 3);
    for (const vec3& y : points) wrong += orient3d(x[0], x[1], x[2], y) > 0;  // all points are below
    for (std::size_t k = 2; k < x.size(); ++k) {
      wrong += orient3d(x[0], x[1], x[2], x[k]) != 0;  // one plane
      six_volumes += dot(cross(x[k - 1] - points[0], x[k] - points[0]), x[0] - points[0]);
    }
    for (std::size_t k = 0; k < x.size(); ++k) {  // no three corners in line
      const vec3 &a = x[k], &b = x[(k + 1) % x.size()], &c = x[(k + 2) % x.size()];
      wrong += orient2d(a, b, c) == 0 && orient2d({a.y, a.z, 0}, {b.y, b.z, 0}, {c.y, c.z, 0}) == 0 && orient2d({a.z, a.x, 0}, {b.z, b.x, 0}, {c.z, c.x, 0}) == 0;
    }
  }
  CHECK(wrong == 0);
  if (hull.dimension == 2) CHECK(num_polys(m) == 2);
  else CHECK(six_volumes > 0);
  return six_volumes / 6;
}

}  // namespace

TEST_CASE("convex_hull: a cube of many points has 8 corners and 6 squares, a tet 4 triangles") {
  const auto cube = convex_hull(grid_points(6));
  CHECK(cube.dimension == 3);
  CHECK(cube.corners.size() == 8);
  CHECK(cube.surface.num_polys() == 6);
  CHECK(check_hull(grid_points(6)) == 216);
  CHECK(check_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.2}, {0.5, 0.5, 0}}) == doctest::Approx(1.0 / 6));
  // an octahedron, with the middles of its edges and the centre
  std::vector<vec3> octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, -0.5}};
  CHECK(convex_hull(octahedron).surface.num_polys() == 8);
  CHECK(check_hull(octahedron) == doctest::Approx(4.0 / 3));
}

TEST_CASE("convex_hull: laws on random points, in general and in special position") {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) check_hull(random_lattice(random, static_cast<std::size_t>(1 + round / 4), 1 + round % 5));
  for (int round = 0; round < 10; ++round) check_hull(random_ball(random, 100, round % 2 == 0));
  CHECK(convex_hull(random_ball(random, 300, true)).corners.size() == 300);
  // a sphere has volume 4/3 pi
  CHECK(check_hull(random_ball(random, 1500, true)) == doctest::Approx(4.18879).epsilon(0.02));
}

TEST_CASE("convex_hull: points of less than three dimensions") {
  CHECK(convex_hull({}).dimension == -1);
  CHECK(convex_hull({}).surface.num_polys() == 0);
  CHECK(convex_hull(std::vector<vec3>{{1, 2, 3}, {1, 2, 3}}).corners == std::vector<std::size_t>{0});
  const auto line = convex_hull(std::vector<vec3>{{1, 1, 1}, {3, 3, 3}, {0, 0, 0}, {2, 2, 2}, {3, 3, 3}});
  CHECK(line.dimension == 1);
  CHECK(line.corners == std::vector<std::size_t>{1, 2});
  for (const vec3& normal : {vec3{0, 0, 1}, vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{1, -2, 4}}) {
    std::vector<vec3> square;  // in a plane through the origin
    const vec3 u = normal.x == 0 ? vec3{1, 0, 0} : normal.y == 0 ? vec3{0, 1, 0} : vec3{2, 1, 0}, v = cross(normal, u);
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j) square.push_back(i * u + j * v);
    const auto flat = convex_hull(square);
    CHECK(flat.dimension == 2);
    CHECK(flat.corners == std::vector<std::size_t>{0, 4, 20, 24});
    CHECK(check_hull(square) == 0);
  }
  CHECK(convex_hull(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).surface.num_polys() == 2);
}

TEST_CASE("convex_hull: the order of the points has no influence, equal points count once") {
  std::mt19937 random(3);
  for (const auto& points : {random_ball(random, 60, false), random_lattice(random, 60, 3)}) {
    const auto hull = convex_hull(points);
    const auto polygons_of = [](const convex_hull_result& h) {
      std::vector<std::vector<std::array<double, 3>>> all;
      for (std::size_t p = 0; p < h.surface.num_polys(); ++p) {
        all.emplace_back();
        for (auto i = h.surface.offsets[p]; i < h.surface.offsets[p + 1]; ++i) {
          const vec3& x = h.surface.points[h.surface.verts[i].raw()];
          all.back().push_back({x.x, x.y, x.z});
        }
        std::rotate(all.back().begin(), std::min_element(all.back().begin(), all.back().end()), all.back().end());
      }
      std::sort(all.begin(), all.end());
      return all;
    };
    for (int round = 0; round < 10; ++round) {
      auto permuted = points;
      permuted.insert(permuted.end(), points.begin(), points.end());
      std::shuffle(permuted.begin(), permuted.end(), random);
      CHECK(polygons_of(convex_hull(permuted)) == polygons_of(hull));
    }
  }
  CHECK(convex_hull(std::vector<vec3>{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}).corners == std::vector<std::size_t>{0, 2, 3, 4});
}

TEST_CASE("convex_hull: points that rounding moves off a plane, and any scale") {
  auto points = grid_points(4);
  for (vec3& x : points) x = testing::rotated(x);
  CHECK(check_hull(points) == doctest::Approx(64).epsilon(1e-12));
  for (const double factor : {0x1p-1000, 0x1p-300, 0x1p300, 0x1p1000}) {
    std::vector<vec3> scaled = grid_points(3);
    for (vec3& x : scaled) x *= factor;
    const auto hull = convex_hull(scaled);
    CHECK(hull.corners.size() == 8);
    CHECK(hull.surface.num_polys() == 6);
    CHECK(hull.surface.points.back() == vec3{3 * factor, 3 * factor, 3 * factor});
  }
}

TEST_CASE("convex_hull: points that are not finite are refused by number") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinite, -infinite}) {
    const std::vector<vec3> points{{0, 0, 0}, {1, 0, 0}, {0, bad, 0}};
    CHECK_THROWS_WITH_AS(convex_hull(points), "convex_hull: point 2 is not finite; leave it out", invalid_argument);
  }
}

TEST_CASE("convex_hull: many points") {
  std::mt19937 random(5);
  const auto hull = convex_hull(random_ball(random, 20000, false));
  CHECK(hull.corners.size() > 100);
  CHECK(convex_hull(grid_points(24)).surface.num_polys() == 6);
}
