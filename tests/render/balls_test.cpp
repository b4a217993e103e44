#include <concino/render/balls.hpp>

#include <concino/mesh/mesh_point.hpp>

#include <doctest/doctest.h>
#include <support/drawables.hpp>
#include <support/kinds.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace concino;
using testing::area_of;
using testing::check_closed;

TEST_CASE("make_balls: balls are round, closed and at their centres") {
  const vec3 centers[] = {{0, 0, 0}, {5, 0, 0}};
  const drawable d = make_balls(centers, {.radius = 2, .color = srgb(1, 0, 0), .opacity = 0.5});
  check_closed(d);
  CHECK(testing::euler_characteristic(d) == 4);
  CHECK(d.look.color == srgb(1, 0, 0));
  CHECK(d.look.opacity == 0.5);
  CHECK(area_of(d) == doctest::Approx(2 * 4 * 3.14159265 * 4).epsilon(0.01));
  for (std::size_t i = 0; i < d.points.size(); ++i) CHECK(distance(d.points[i], centers[i / (d.points.size() / 2)]) == doctest::Approx(2));
  for (std::size_t c = 0; c < d.corners.size(); c += 7) CHECK(norm(d.points[d.corners[c]] - centers[d.polys[c / 3]] - 2 * to_vec3(d.normals[c])) < 1e-6);
}

TEST_CASE("make_balls: points of any type, and the verts of a mesh or a graph") {
  const drawable d = make_balls({{0, 0, 0}, {5, 0, 0}}, {.radius = 1});
  const std::vector<std::array<float, 3>> floats = {{{0, 0, 0}}, {{5, 0, 0}}};
  CHECK(make_balls(floats, {.radius = 1}).points == d.points);
  const std::vector<mesh_point<trimesh>> places = {{vert_id{0}, {0, 0, 0}}, {vert_id{1}, {5, 0, 0}}};
  CHECK(make_balls(places, {.radius = 1}).points == d.points);
  const tetmesh m = testing::grid<tetmesh>(1);
  const drawable at_verts = make_balls(m, {.radius = 0.1, .triangles = 20});
  CHECK(at_verts.triangles.size() == 20 * num_verts(m));
  for (const std::uint32_t p : at_verts.polys) CHECK(p < num_verts(m));
  CHECK(make_balls(std::vector<vec3>{}).triangles.empty());
}

TEST_CASE("make_balls: values, colours and radii by point; the default radius; many balls have few triangles") {
  const std::vector<vec3> points = {{0, 0, 0}, {0, 30, 40}};
  CHECK(distance(make_balls(points).points[0], points[0]) == doctest::Approx(0.4));
  const std::vector<double> numbers = {3, 7};
  const std::vector<rgb> colors = {{1, 0, 0}, {0, 1, 0}};
  const drawable d = make_balls(points, {.values = numbers, .colors = colors, .radii = numbers, .triangles = 80});
  REQUIRE(d.values.size() == d.points.size());
  REQUIRE(d.colors.size() == d.points.size());
  CHECK(d.colors_at == value_place::points);
  for (std::size_t i = 0; i < d.points.size(); ++i) {
    const std::size_t ball = i / 42;
    CHECK(d.values[i] == numbers[ball]);
    CHECK(d.colors[i] == colors[ball]);
    CHECK(distance(d.points[i], points[ball]) == doctest::Approx(numbers[ball]));
  }
  CHECK(d.look.scale.low() == 3);
  CHECK(d.look.scale.high() == 7);
  CHECK(make_balls(points, {.values = numbers, .scale = value_scale::linear(0, 10)}).look.scale.high() == 10);
  const auto triangles_of = [](std::size_t n) { return make_balls(std::vector<vec3>(n)).triangles.size() / n; };
  CHECK(triangles_of(50) == 1280);
  CHECK(triangles_of(51) == 320);
  CHECK(triangles_of(1001) == 80);
  CHECK(triangles_of(10001) == 20);
}

TEST_CASE("make_balls: invalid input throws") {
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const std::vector<vec3> points = {{0, 0, 0}, {1, 0, 0}};
  const std::vector<double> one = {1}, zero = {1, 0};
  const std::vector<rgb> color(1);
  CHECK_THROWS_AS(make_balls({{0, not_a_number, 0}}), invalid_argument);
  CHECK_THROWS_AS(make_balls(points, {.radius = -1}), invalid_argument);
  CHECK_THROWS_AS(make_balls(points, {.radius = not_a_number}), invalid_argument);
  CHECK_THROWS_AS(make_balls(points, {.opacity = -1}), invalid_argument);
  CHECK_THROWS_AS(make_balls(points, {.triangles = 21}), invalid_argument);
  CHECK_THROWS_AS(make_balls(points, {.values = one}), invalid_argument);
  CHECK_THROWS_AS(make_balls(points, {.colors = color}), invalid_argument);
  CHECK_THROWS_AS(make_balls(points, {.radii = one}), invalid_argument);
  CHECK_THROWS_AS(make_balls(points, {.radii = zero}), invalid_argument);
}
