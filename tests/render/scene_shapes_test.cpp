#include <concino/render/render.hpp>
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

TEST_CASE("scene: pictures show lines, points and arrows where they are, in their colours") {
  const quadmesh m = testing::grid<quadmesh>(1);
  const auto g = make_poly_map<vec3>(m, vec3{0, 1, 0});
  scene s;
  s.add(m)
      .add_lines({{0, 0.25, 0}, {1, 0.25, 0}}, {.radius = 0.05, .color = {1, 0, 0}})
      .add_points({{0.25, 0.75, 0}}, {.radius = 0.08, .color = {0, 1, 0}})
      .add_arrows(m, g, {.scale = 0.8, .radius = 0.04, .color = {0, 0, 1}});
  render_options o{.width = 40, .height = 40, .camera = camera::from_front, .samples = 2, .occlusion_rays = 0};
  o.ground = false;
  const image picture = render(s, o);
  const camera c = view(camera::from_front).of(s.drawables(), 1);
  const auto pixel_at = [&](const vec3& p) {
    const image_point f = c.project(p);
    return picture(static_cast<std::size_t>(20 + 20 * f.x), static_cast<std::size_t>(20 - 20 * f.y));
  };
  const auto is_mostly = [](float a, float b, float d) { return a > 2.5f * b && a > 2.5f * d; };
  for (const double x : {0.1, 0.5, 0.9}) {
    const rgb red = pixel_at({x, 0.25, 0});
    CHECK(is_mostly(red.r, red.g, red.b));
  }
  const rgb green = pixel_at({0.25, 0.75, 0}), blue = pixel_at({0.5, 0.58, 0}), plain = pixel_at({0.75, 0.75, 0});
  CHECK(is_mostly(green.g, green.r, green.b));
  CHECK(is_mostly(blue.b, blue.r, blue.g));
  CHECK(plain.r == doctest::Approx(plain.g).epsilon(0.1));
}
