#include <concino/render/scene.hpp>

#include <concino/concepts/facets.hpp>
#include <concino/graph/boundary_loops.hpp>
#include <concino/mesh/element_map.hpp>

#include <doctest/doctest.h>
#include <support/kinds.hpp>

#include <algorithm>

using namespace concino;

TEST_CASE("scene: lines, graphs, points and arrows are added by one call each") {
  const quadmesh m = testing::grid<quadmesh>(3);
  const auto g = make_poly_map<vec3>(m, vec3{0, 0, 1});
  const std::vector<vec3> points = {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}};
  scene s;
  s.add_lines(points, {.radius = 0.004, .color = {1, 0, 0}})
      .add_lines({{0, 0, 0}, {1, 1, 1}})
      .add_lines(m, boundary_loops(m).loops)
      .add_graph(m)
      .add_graph(m, [&](edge_id e) { return is_boundary(m, e); }, {.opacity = 0.5})
      .add_points(points)
      .add_points({{1, 1, 1}}, {.radius = 0.5})
      .add_points(m)
      .add_arrows(m, g, {.scale = 0.5});
  REQUIRE(s.drawables().size() == 9);
  CHECK(s.drawables()[0].look.color == rgb{1, 0, 0});
  CHECK(s.drawables()[4].look.opacity == 0.5);
  CHECK(s.drawables()[8].points == make_arrows(m, g).points);
}

TEST_CASE("scene: a radius of 0 fits what was added before") {
  scene s;
  CHECK(s.bounds().is_empty());
  s.add_lines({{0, 0, 0}, {0, 30, 40}});  // 0.4 % of its own length
  CHECK(s.bounds().max.x == doctest::Approx(0.2));
  s.add_points({{0, 0, 0}});
  const auto& ball = s.drawables().back().points;
  CHECK(norm(ball[0]) == doctest::Approx(0.008 * 50).epsilon(0.02));
  s.add_lines({{9, 0, 0}, {9, 1, 0}}, {.radius = 1});
  CHECK(s.bounds().max.x == doctest::Approx(10));
}
