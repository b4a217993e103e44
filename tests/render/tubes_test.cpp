#include <concino/render/tubes.hpp>

#include <concino/concepts/views.hpp>
#include <concino/graph/boundary_loops.hpp>
#include <concino/graph/shortest_path.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/render/detail/shapes/shape_size.hpp>

#include <doctest/doctest.h>
#include <support/drawables.hpp>
#include <support/kinds.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace concino;
using testing::area_of;
using testing::check_closed;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

double distance_to_segment(const vec3& p, const vec3& a, const vec3& b) {
  const vec3 e = b - a;
  const double length = dot(e, e), t = length > 0 ? std::clamp(dot(p - a, e) / length, 0.0, 1.0) : 0;
  return distance(p, a + e * t);
}

/// The distances of the points of a drawable from a polyline, the smallest and the largest.
std::pair<double, double> distances(const drawable& d, const std::vector<vec3>& line) {
  std::pair<double, double> range{std::numeric_limits<double>::infinity(), 0};
  for (const vec3& p : d.points) {
    double nearest = distance(p, line[0]);
    for (std::size_t i = 1; i < line.size(); ++i) nearest = std::min(nearest, distance_to_segment(p, line[i - 1], line[i]));
    range = {std::min(range.first, nearest), std::max(range.second, nearest)};
  }
  return range;
}

bool has_unit_normals(const drawable& d) {
  return std::all_of(d.normals.begin(), d.normals.end(), [](const auto& n) { return std::abs(norm(to_vec3(n)) - 1) < 1e-5; });
}

std::vector<vec3> helix(std::size_t n) {
  std::vector<vec3> line;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 6 * pi * static_cast<double>(i) / static_cast<double>(n - 1);
    line.push_back({std::cos(t), std::sin(t), t / 10});
  }
  return line;
}

std::vector<vec3> circle(std::size_t n) {
  std::vector<vec3> line;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
    line.push_back({std::cos(t), std::sin(t), 0.2 * std::sin(3 * t)});
  }
  return line;
}

}  // namespace

TEST_CASE("make_tubes: a straight tube is a cylinder with half balls at its ends") {
  const std::vector<vec3> line = {{1, 2, 3}, {2, 4, 5}};
  const drawable d = make_tubes(line, {.radius = 0.25, .corners = 64});
  check_closed(d);
  CHECK(area_of(d) == doctest::Approx(2 * pi * 0.25 * 3 + 4 * pi * 0.0625).epsilon(0.005));
  const auto [low, high] = distances(d, line);
  CHECK(low == doctest::Approx(0.25).epsilon(1e-12));
  CHECK(high == doctest::Approx(0.25).epsilon(1e-12));
}

TEST_CASE("make_tubes: the points of curved tubes are at the radius from the line, and normals point away from it") {
  for (const double tolerance : {0.0, 0.03}) {
    const std::vector<vec3> line = helix(200);
    const drawable d = make_tubes(line, {.radius = 0.1, .tolerance = tolerance});
    check_closed(d);
    const auto [low, high] = distances(d, line);
    CHECK(low > 0.1 * (0.99 - tolerance));
    CHECK(high < 0.1 * (1.001 + tolerance));
    const double length = 6 * pi * std::hypot(1.0, 0.1);
    CHECK(area_of(d) == doctest::Approx(2 * pi * 0.1 * length + 4 * pi * 0.01).epsilon(0.03));
    CHECK(has_unit_normals(d));
  }
  CHECK(make_tubes(helix(2000), {.radius = 0.1}).points.size() < make_tubes(helix(2000), {.radius = 0.1, .tolerance = 0}).points.size() / 5);
}

TEST_CASE("make_tubes: closed lines are closed and are not twisted") {
  for (const std::size_t n : {3u, 4u, 50u}) {
    const drawable d = make_tubes(circle(n), {.radius = 0.05, .closed = true, .corners = 8, .tolerance = 0});
    check_closed(d);
    CHECK(testing::euler_characteristic(d) == 0);
    std::vector<vec3> line = circle(n);
    line.push_back(line[0]);
    const auto [low, high] = distances(d, line);
    CHECK(low > 0);
    CHECK(high == doctest::Approx(0.05));
    // Lines along the tube run along it: no edge of a quad is much longer than the segment.
    const double longest = distance(line[0], line[1]) * (n == 50 ? 1.2 : 1.6);
    int long_quads = 0;
    for (std::size_t p = 0; p + 1 < d.offsets.size(); ++p) {
      const auto at = [&](std::uint32_t k) { return d.points[d.corners[d.offsets[p] + k]]; };
      long_quads += distance(at(1), at(2)) > longest;
    }
    CHECK(long_quads == 0);
  }
  // The first point given again at the end, and closed lines of one or two points.
  std::vector<vec3> again = circle(10);
  again.push_back(again[0]);
  CHECK(make_tubes(again, {.radius = 0.05, .closed = true}).points == make_tubes(circle(10), {.radius = 0.05, .closed = true}).points);
  check_closed(make_tubes({{0, 0, 0}}, {.radius = 1, .closed = true}));
  check_closed(make_tubes({{0, 0, 0}, {1, 0, 0}}, {.radius = 1, .closed = true}));
}

TEST_CASE("make_tubes: sharp turns are round, half turns too, and points may repeat") {
  for (const vec3 third : {vec3{1, 1, 0}, vec3{0, 0, 0}, vec3{0.5, 0.1, 0}, vec3{1e-9, 0, 0}, vec3{2, 0, 0}}) {
    const std::vector<vec3> line = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, third, third};
    const drawable d = make_tubes(line, {.radius = 0.1});
    check_closed(d);
    CHECK(testing::euler_characteristic(d) == 2);
    CHECK(std::all_of(d.points.begin(), d.points.end(), [](const vec3& p) { return is_finite(p); }));
    CHECK(has_unit_normals(d));
    CHECK(distances(d, line).second == doctest::Approx(0.1));
  }
  // The outer side of a right angle is at the radius, not cut off.
  const drawable corner = make_tubes({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {.radius = 0.1, .corners = 32});
  double farthest = 0;
  for (const vec3& p : corner.points) farthest = std::max(farthest, dot(p - vec3{1, 0, 0}, vec3{1, -1, 0}) / std::sqrt(2));
  CHECK(farthest > 0.098);
}

TEST_CASE("make_tubes: single points are balls, lines without points are nothing") {
  const std::vector<std::vector<vec3>> lines = {{}, {{1, 2, 3}}, {{4, 4, 4}, {4, 4, 4}}, {}};
  const drawable d = make_tubes(lines, {.radius = 0.5, .corners = 32});
  check_closed(d);
  CHECK(area_of(d) == doctest::Approx(2 * 4 * pi * 0.25).epsilon(0.02));
  CHECK(std::all_of(d.polys.begin(), d.polys.end(), [](std::uint32_t p) { return p == 1 || p == 2; }));
  CHECK(make_tubes(std::vector<std::vector<vec3>>{}).triangles.empty());
  CHECK(make_tubes(std::vector<vec3>{}).triangles.empty());
  CHECK(!make_tubes({{7, 7, 7}}).triangles.empty());
}

TEST_CASE("make_tubes: takes points of other types, level sets and walks along a mesh") {
  const drawable d = make_tubes({{0, 0, 0}, {1, 0, 0}}, {.radius = 0.1});
  const float floats[2][3] = {{0, 0, 0}, {1, 0, 0}};
  CHECK(make_tubes(floats, {.radius = 0.1}).points == d.points);
  const std::vector<std::vector<std::array<double, 3>>> arrays = {{{{0, 0, 0}}, {{1, 0, 0}}}};
  CHECK(make_tubes(arrays, {.radius = 0.1}).points == d.points);
  const polygonmesh m = testing::grid<polygonmesh>(4);
  const std::vector<mesh_point<polygonmesh>> places = {{vert_id{0}, {0, 0, 0}}, {vert_id{1}, {1, 0, 0}}};
  CHECK(make_tubes(places, {.radius = 0.1}).points == d.points);

  auto u = make_vert_map<double>(m, 0.0);
  for (const auto v : verts(m)) u[v] = distance(to_vec3(point(m, v)), {0.5, 0.5, 0});
  const auto lines = isolines(m, u, {0.3});
  REQUIRE(lines.size() == 1);
  REQUIRE(lines[0].closed);
  CHECK(testing::euler_characteristic(make_tubes(lines, {.radius = 0.01})) == 0);
  CHECK(testing::euler_characteristic(make_tubes(lines[0], {.radius = 0.01})) == 0);
  const auto border = boundary_loops(m).loops;
  CHECK(testing::euler_characteristic(make_tubes(m, border, {.radius = 0.01})) == 0);
  const auto path = shortest_path(m, *verts(m).begin(), border[0].verts[border[0].verts.size() / 2]);
  std::vector<vec3> points;
  for (const auto v : path) points.push_back(to_vec3(point(m, v)));
  CHECK(make_tubes(m, path, {.radius = 0.01}).points == make_tubes(points, {.radius = 0.01}).points);
  CHECK(make_tubes(primal(m), path, {.radius = 0.01}).points == make_tubes(points, {.radius = 0.01}).points);
  const std::vector<poly_id> two = {poly_id{0}, poly_id{1}};
  CHECK(distances(make_tubes(m, two, {.radius = 0.01}), {centroid(m, two[0]), centroid(m, two[1])}).second == doctest::Approx(0.01));
}

TEST_CASE("make_tubes: values by point and by line, radii, and the default radius") {
  const std::vector<std::vector<vec3>> lines = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 0}, {3, 4, 0}}};
  const std::vector<double> by_point = {0, 5, 6, 7, not_a_number}, by_line = {3, 4};
  const drawable d = make_tubes(lines, {.radius = 0.1, .values = by_point, .map = colormap::viridis});
  REQUIRE(d.values.size() == d.points.size());
  CHECK(d.values_at == value_place::points);
  CHECK(d.look.scale.low() == 0);
  CHECK(d.look.scale.high() == 7);
  for (std::size_t i = 0; i < d.points.size(); ++i) {
    if (d.points[i].y < 0.5 && std::abs(d.points[i].x - 1) < 0.01) CHECK(d.values[i] == 5);
    if (d.points[i].x > 2.8) CHECK(std::isnan(d.values[i]));
  }
  const drawable e = make_tubes(lines, {.radius = 0.1, .values = by_line, .scale = value_scale::linear(0, 10)});
  CHECK(e.look.scale.high() == 10);
  for (std::size_t p = 0; p < e.polys.size(); ++p) CHECK(e.values[e.corners[e.offsets[p]]] == by_line[e.polys[p]]);

  const std::vector<double> radii = {0.1, 0.3, 0.2, 0.1, 0.1};
  const drawable r = make_tubes(lines, {.radii = radii, .corners = 32});
  check_closed(r);
  double widest = 0;
  for (const vec3& p : r.points)
    if (std::abs(p.x - 1) < 0.01) widest = std::max(widest, std::hypot(p.y, p.z));
  CHECK(widest == doctest::Approx(0.3));

  const std::vector<vec3> diagonal = {{0, 0, 0}, {0, 30, 40}};
  CHECK(distances(make_tubes(diagonal), diagonal).second == doctest::Approx(0.2));
}

TEST_CASE("make_tubes: many lines have few corners") {
  const auto corners_for = [](std::size_t n) {
    return make_tubes(std::vector<vec3>(n), {.radius = 1}).points.size();  // a ball
  };
  CHECK(corners_for(10) > corners_for(5000));
  CHECK(corners_for(5000) > corners_for(41000));
}

TEST_CASE("make_tubes: invalid input throws") {
  const std::vector<vec3> line = {{0, 0, 0}, {1, 0, 0}};
  CHECK_THROWS_AS(make_tubes({{0, 0, 0}, {1, not_a_number, 0}}), invalid_argument);
  CHECK_THROWS_AS(make_tubes(line, {.radius = -1}), invalid_argument);
  CHECK_THROWS_AS(make_tubes(line, {.radius = not_a_number}), invalid_argument);
  CHECK_THROWS_AS(make_tubes(line, {.opacity = 2}), invalid_argument);
  CHECK_THROWS_AS(make_tubes(line, {.corners = 2}), invalid_argument);
  CHECK_THROWS_AS(make_tubes(line, {.tolerance = -1}), invalid_argument);
  const std::vector<double> three = {1, 2, 3}, zero = {1, 0};
  CHECK_THROWS_AS(make_tubes(line, {.values = three}), invalid_argument);
  CHECK_THROWS_AS(make_tubes(line, {.radii = three}), invalid_argument);
  CHECK_THROWS_AS(make_tubes(line, {.radii = zero}), invalid_argument);
  CHECK_THROWS_AS(detail::check_shape_size("make_tubes", std::size_t{1} << 32), unsupported);
}
