#include <concino/geometry/triangulate_polygon.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

using namespace concino;

namespace {

using polygon = std::vector<vec3>;

vec3 vector_area(const polygon& p) {
  vec3 n;
  for (std::size_t i = 2; i < p.size(); ++i) n += cross(p[i - 1] - p[0], p[i] - p[0]);
  return n / 2;
}

// Checks the properties of a triangulation of a polygon that is simple in the plane of its vector area.
void check_simple(const polygon& p) {
  const auto triangles = triangulate_polygon(p);
  REQUIRE(triangles.size() == p.size() - 2);
  const vec3 whole = vector_area(p);
  const double area = norm(whole);
  REQUIRE(area > 0);
  double sum = 0, worst = 0;
  for (const auto& t : triangles) {
    const double a = dot(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]), whole) / (2 * area);
    sum += std::abs(a);
    worst = std::min(worst, a);
  }
  CHECK(sum == doctest::Approx(area).epsilon(1e-9));
  CHECK(worst >= -1e-12 * area);
}

// Checks that n-2 triangles use each edge of the polygon once, and each diagonal twice, in opposite directions.
void check_joined(std::size_t n, const std::vector<polygon_triangle>& triangles) {
  REQUIRE(triangles.size() == n - 2);
  std::set<std::pair<std::size_t, std::size_t>> sides;
  std::size_t once = 0, paired = 0;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) once += sides.emplace(t[k], t[(k + 1) % 3]).second;
  CHECK(once == 3 * triangles.size());
  for (std::size_t i = 0; i < n; ++i) sides.erase({i, (i + 1) % n});
  CHECK(sides.size() == 2 * (n - 3));
  for (const auto& s : sides) paired += sides.count({s.second, s.first});
  CHECK(paired == sides.size());
}

polygon flat(std::initializer_list<std::pair<double, double>> corners) {
  polygon p;
  for (const auto& [x, y] : corners) p.push_back({x, y, 0});
  return p;
}

polygon rotated(polygon p, double scale, const vec3& shift) {
  for (vec3& x : p) x = vec3{0.36 * x.x + 0.48 * x.y - 0.8 * x.z, -0.8 * x.x + 0.6 * x.y, 0.48 * x.x + 0.64 * x.y + 0.6 * x.z} * scale + shift;
  return p;
}

polygon reversed(const polygon& p) { return {p.rbegin(), p.rend()}; }

polygon spiral(int n) {
  polygon p;
  const auto at = [](double t, double r) { return vec3{r * t * std::cos(t), r * t * std::sin(t), 0}; };
  for (int i = 0; i <= n; ++i) p.push_back(at(6 + 30.0 * i / n, 1.0));
  for (int i = n; i >= 0; --i) p.push_back(at(6 + 30.0 * i / n, 0.95));
  return p;
}

const polygon letter_e = flat({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 4}, {3, 4}, {3, 5}, {0, 5}});

}  // namespace

TEST_CASE("triangulate_polygon: triangles cover a simple polygon, and none is flipped") {
  const std::vector<polygon> shapes = {
      flat({{0, 0}, {1, 0}, {0, 1}}),
      flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}}),
      flat({{0, 0}, {4, 0}, {1, 1}, {0, 4}}),                                                // an arrow: one diagonal is outside
      flat({{1, 1}, {0, 4}, {0, 0}, {4, 0}}),
      flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}),                // a square with four flat corners
      flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}}),
      flat({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}),
      flat({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}}),  // a square with a hole, connected to it by a cut
      letter_e,
      spiral(20),
      spiral(300),
  };
  for (const polygon& p : shapes) {
    CAPTURE(p.size());
    for (const double scale : {1.0, 1e-200, 1e-9, 1e9, 1e70})
      for (std::size_t first = 0; first < p.size(); first += 1 + p.size() / 12) {
        polygon q(p.begin() + static_cast<std::ptrdiff_t>(first), p.end());
        q.insert(q.end(), p.begin(), p.begin() + static_cast<std::ptrdiff_t>(first));
        check_joined(q.size(), triangulate_polygon(q));
        if (scale > 1e-100) {
          check_simple(rotated(q, scale, {}));
          check_simple(rotated(reversed(q), scale, vec3{1, 2, 3} * scale));
        }
        CHECK(triangulate_polygon(rotated(q, scale, {})).size() == q.size() - 2);
      }
  }
}

TEST_CASE("triangulate_polygon: a non-planar polygon is projected along its vector area") {
  polygon p = letter_e;
  for (std::size_t i = 0; i < p.size(); ++i) p[i].z = 0.05 * std::sin(7.0 * static_cast<double>(i));
  check_simple(rotated(p, 1, {}));
}

TEST_CASE("triangulate_polygon: works on random star-shaped polygons with flat corners") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.05, 1);
  for (int repeat = 0; repeat < 300; ++repeat) {
    polygon p;
    const int n = 3 + repeat;
    for (int i = 0; i < n; ++i) {
      const double t = 6.283185307179586 * i / n, r = unit(random);
      p.push_back({r * std::cos(t), r * std::sin(t), 0});
    }
    if (repeat % 2)
      for (std::size_t i = p.size() - 1; i-- > 0;)
        p.insert(p.begin() + static_cast<std::ptrdiff_t>(i) + 1, p[i] + (p[i + 1] - p[i]) * 0.5);
    check_simple(rotated(p, 1, {3, 2, 1}));
    check_joined(p.size(), triangulate_polygon(p));
  }
}

TEST_CASE("triangulate_polygon: polygons that are not simple give n-2 triangles with all corners") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<polygon> shapes = {
      flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}),                   // collinear points
      flat({{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}}),                   // equal points
      flat({{0, 0}, {1, 1}, {1, 0}, {0, 1}}),                           // a bow tie
      flat({{0, 0}, {2, 3}, {4, 0}, {0, 2}, {4, 2}}),                   // a pentagram
      flat({{0, 0}, {2, 0}, {1, 0}, {3, 0}, {3, 1}, {0, 1}}),           // an edge that runs back on the previous one
      flat({{0, 0}, {nan, 0}, {1, 1}, {0, 1}, {-1, 0}}),
      flat({{0, 0}, {1e308, 0}, {1e308, 1e308}, {-1e308, 1e308}, {-1e308, 0}}),
  };
  for (const polygon& p : shapes) check_joined(p.size(), triangulate_polygon(p));
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (std::size_t n = 3; n < 200; ++n) {
    polygon p(n);
    for (vec3& x : p) x = {unit(random), unit(random), unit(random)};
    check_joined(n, triangulate_polygon(p));
  }
  CHECK(triangulate_polygon({}).empty());
  CHECK(triangulate_polygon(polygon(2)).empty());
}

TEST_CASE("triangulate_polygon: a hundred thousand corners take little time") {
  check_simple(spiral(50000));
}

TEST_CASE("triangulate_polygon: seen from above, by exact tests") {
  polygon_triangulator cut;
  const polygon bridged = {{0, 0, 9}, {3, 0, 1}, {3, 3, 0}, {0, 3, -5}, {0, 0, 9}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}};
  double sum = 0;
  for (const auto& t : cut.from_above(bridged)) {
    CHECK(orient2d(bridged[t[0]], bridged[t[1]], bridged[t[2]]) == 1);
    sum += cross(bridged[t[1]] - bridged[t[0]], bridged[t[2]] - bridged[t[0]]).z / 2;
  }
  CHECK(sum == doctest::Approx(8));
  polygon nearly_flat;  // one step of rounding wide
  for (int i = 0; i <= 100; ++i) nearly_flat.push_back({i, i, 0});
  for (int i = 99; i > 0; --i) nearly_flat.push_back({i, std::nextafter(double(i), 200), 0});
  const auto triangles = cut.from_above(nearly_flat);
  check_joined(nearly_flat.size(), {triangles.begin(), triangles.end()});
  for (const auto& t : triangles) CHECK(orient2d(nearly_flat[t[0]], nearly_flat[t[1]], nearly_flat[t[2]]) == 1);
  CHECK(cut.from_above({}).empty());
}

TEST_CASE("triangulate_polygon: neither the first corner nor the direction changes the triangles") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<polygon> shapes = {flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), flat({{0, 0}, {2, 0}, {3, 1}, {2, 2}, {0, 2}, {-1, 1}}),
                                 flat({{0, 0}, {1, 0}, {0, 0}, {1, 0}, {0, 1}}), flat({{0, 0}, {2, 3}, {4, 0}, {0, 2}, {4, 2}})};
  for (std::size_t n = 4; n < 80; n = 2 * n - 1) {
    polygon p(n);
    for (std::size_t k = 0; k < n; ++k) {  // concave and not planar
      const double angle = 6.283185307179586 * static_cast<double>(k) / static_cast<double>(n), radius = 2 + unit(random);
      p[k] = {radius * std::cos(angle), radius * std::sin(angle), 0.3 * unit(random)};
    }
    shapes.push_back(p);
  }
  const auto points_of = [](const polygon& p) {  // each triangle as its sorted points
    std::vector<std::vector<std::array<double, 3>>> all;
    for (const auto& t : triangulate_polygon(p)) {
      auto& points = all.emplace_back();
      for (const auto k : t) points.push_back({p[k].x, p[k].y, p[k].z});
      std::sort(points.begin(), points.end());
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  for (const polygon& shape : shapes) {
    const auto expected = points_of(shape);
    for (polygon p : {shape, polygon(shape.rbegin(), shape.rend())})
      for (std::size_t k = 0; k < p.size(); ++k) {
        std::rotate(p.begin(), p.begin() + 1, p.end());
        CHECK(points_of(p) == expected);
        check_joined(p.size(), triangulate_polygon(p));
      }
  }
}
