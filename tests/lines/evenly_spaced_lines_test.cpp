#include <concino/lines/evenly_spaced_lines.hpp>

#include <concino/core/error.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace concino;

namespace {

/// Points along a line, less than `spacing` apart.
template<class M>
std::vector<vec3> points_along(const field_line<M>& line, double spacing) {
  std::vector<vec3> x;
  for (std::size_t i = 0; i < line.polys.size(); ++i) {
    const vec3 &a = line.points[i].position, &b = line.points[(i + 1) % line.points.size()].position;
    const int n = static_cast<int>(distance(a, b) / spacing) + 1;
    for (int k = 0; k <= n; ++k) x.push_back(a + k / double(n) * (b - a));
  }
  return x;
}

double distance_between(const std::vector<vec3>& a, const std::vector<vec3>& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const vec3& x : a)
    for (const vec3& y : b) least = std::min(least, distance(x, y));
  return least;
}

template<class M>
void check_spacing(const M& m, const std::vector<field_line<M>>& lines, double spacing) {
  REQUIRE(!lines.empty());
  std::vector<std::vector<vec3>> all;
  for (const auto& line : lines) all.push_back(points_along(line, spacing / 8));
  double least = std::numeric_limits<double>::infinity(), farthest = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, distance_between(all[i], all[j]));
  CHECK(least > 0.495 * spacing);
  std::size_t far = 0;
  for (const auto v : verts(m)) {
    double d = std::numeric_limits<double>::infinity();
    for (const auto& line : all) d = std::min(d, distance_between({to_vec3(point(m, v))}, line));
    farthest = std::max(farthest, d);
    far += d > 1.1 * spacing;
  }
  CHECK(farthest < 2.5 * spacing);
  CHECK(far <= num_verts(m) / 20);  // in corners, lines would be too short
}

}  // namespace

TEST_CASE_TEMPLATE("evenly_spaced_lines: straight lines across a square have the distance", M, trimesh, polygonmesh) {
  const M m = make_grid<M>({.cells = {12, 12}});
  auto g = make_poly_map<vec3>(m);
  for (const auto p : polys(m)) g[p] = {0.001, 1, 0};
  const auto lines = evenly_spaced_lines(m, g, {.distance = 0.1});
  CHECK(lines.size() >= 9);
  CHECK(lines.size() <= 12);
  for (const auto& line : lines) CHECK(line.length > 0.2);
  check_spacing(m, lines, 0.1);
}

TEST_CASE("evenly_spaced_lines: circles close, and cover a square and a sphere") {
  const auto m = make_grid<trimesh>({.cells = {16, 16}, .min = {-1, -1, 0}, .max = {1, 1, 0}});
  auto g = make_poly_map<vec3>(m);
  for (const auto p : polys(m)) {
    const vec3 x = centroid(m, p);
    g[p] = {-x.y, x.x, 0};
  }
  check_spacing(m, evenly_spaced_lines(m, g, {.distance = 0.15}), 0.15);
  const auto sphere = make_sphere<trimesh>();
  auto round = make_poly_map<vec3>(sphere);
  for (const auto p : polys(sphere)) round[p] = cross({0.2, 0.3, 1}, centroid(sphere, p));
  check_spacing(sphere, evenly_spaced_lines(sphere, round, {.distance = 0.25}), 0.25);
}

TEST_CASE_TEMPLATE("evenly_spaced_lines: keep their distance up to the ends of lines", M, trimesh, quadmesh) {
  M m = make_grid<M>({.cells = {7, 7}});
  jitter(m, 0.3);
  auto g = make_poly_map<vec3>(m);
  for (const auto p : polys(m)) {
    const vec3 x = centroid(m, p);
    g[p] = {0.5 - x.y, x.x - 0.5, 0};
  }
  for (const double spacing : {0.1, 0.3})
    for (const double part : {0.5, 0.8}) {
      std::vector<std::vector<vec3>> all;
      for (const auto& line : evenly_spaced_lines(m, g, {.distance = spacing, .stops_below = part})) all.push_back(points_along(line, spacing / 16));
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, distance_between(all[i], all[j]));
      CHECK(all.size() > 2);
      CHECK(least > 0.99 * part * spacing);
    }
}

TEST_CASE("evenly_spaced_lines: begins where the density is greatest; sheets that lie close to each other do not count") {
  auto m = make_grid<trimesh>({.cells = {8, 8}});
  const std::size_t one_sheet = num_polys(m);
  const auto second = make_grid<trimesh>({.cells = {8, 8}, .min = {0, 0, 0.01}, .max = {1, 1, 0.02}});
  std::vector<vert_id> twin;
  for (const auto v : verts(second)) twin.push_back(add_vert(m, point(second, v)));
  for (const auto p : polys(second)) {
    std::vector<vert_id> corners;
    for (const auto v : adj_p2v(second, p)) corners.push_back(twin[index_of(second, v)]);
    add_poly(m, corners);
  }
  auto g = make_poly_map<vec3>(m);
  auto density = make_poly_map<double>(m);
  for (const auto p : polys(m)) {
    g[p] = {1, 0.01, 0};
    density[p] = centroid(m, p).y - centroid(m, p).z;
  }
  const auto lines = evenly_spaced_lines(m, g, density, {.distance = 0.2});
  std::size_t low = 0, high = 0;
  for (const auto& line : lines) (index_of(m, line.polys[0]) < one_sheet ? low : high)++;
  CHECK(low >= 4);
  CHECK(low == high);
  CHECK(lines[0].points[0].position.y > 0.9);
}

TEST_CASE("evenly_spaced_lines: errors") {
  const auto m = make_grid<trimesh>({.cells = {3, 3}});
  auto g = make_poly_map<vec3>(m);
  CHECK(evenly_spaced_lines(m, g, {.distance = 0.1}).empty());  // no field, no lines
  CHECK_THROWS_WITH_AS(evenly_spaced_lines(m, g, {}), "evenly_spaced_lines: distance is 0; it must be above 0 and finite", invalid_argument);
  CHECK_THROWS_WITH_AS(evenly_spaced_lines(m, g, {.distance = 1, .stops_below = 2}), "evenly_spaced_lines: stops_below is 2; it must be above 0 and at most 1", invalid_argument);
  CHECK_THROWS_WITH_AS(evenly_spaced_lines(m, g, {.distance = 1, .min_length = -1}), "evenly_spaced_lines: min_length is -1; it must be at least 0", invalid_argument);
  CHECK_THROWS_AS(evenly_spaced_lines(m, g, {.distance = 1, .progress = [](double, const char*) { return false; }}), cancelled);
  auto density = make_poly_map<double>(m);
  density[poly_id{2}] = std::nan("");
  CHECK_THROWS_WITH_AS(evenly_spaced_lines(m, g, density, {.distance = 1}), "evenly_spaced_lines: the density at poly 2 is not a number (NaN)", invalid_argument);
  g[poly_id{1}] = {std::nan(""), 0, 0};
  CHECK_THROWS_WITH_AS(evenly_spaced_lines(m, g, {.distance = 1}), "evenly_spaced_lines: the vector at poly 1 is not finite; give each poly a finite vector", invalid_argument);
}
