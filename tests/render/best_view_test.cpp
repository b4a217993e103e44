#include <concino/render/best_view.hpp>
#include <concino/render/shapes.hpp>

#include <doctest/doctest.h>

#include <vector>

using namespace concino;

TEST_CASE("best_view: shows a mark on the far side; without marks it keeps the preferred view") {
  const view_options first;
  const vec3 middle{0.5, 0.5, 0.5}, behind{0.5, 0.5, 0};
  std::vector<drawable> scene = {make_balls({middle}, {.radius = 0.5, .color = srgb(1, 1, 1)})};
  const camera plain = best_view(scene, 1, first);
  CHECK(norm(plain.back - first.towards / norm(first.towards)) == doctest::Approx(0));
  scene.push_back(make_balls({behind}, {.radius = 0.05, .color = srgb(1, 0, 0)}));
  CHECK(best_view(scene, 1, first).back.z < 0.3);  // rotated until the mark is visible beside the ball
}

TEST_CASE("best_view: an empty scene has the preferred view; options out of range throw") {
  const camera c = best_view({}, 1, {.towards = {0, 0, 1}});
  CHECK(c.back.z == doctest::Approx(1));
  CHECK_THROWS_AS(best_view({}, 0), invalid_argument);
  CHECK_THROWS_AS(best_view({}, 1, {.margin = 1}), invalid_argument);
  CHECK_THROWS_AS(best_view({}, 1, {.up = {0, 0, 0}}), invalid_argument);
}
