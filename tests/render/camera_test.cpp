#include <concino/render/camera.hpp>

#include <doctest/doctest.h>

#include <random>
#include <vector>

using namespace concino;

namespace {

void check_rays_and_projection(const camera& c) {
  CHECK(dot(c.right, c.up) == doctest::Approx(0));
  CHECK(dot(c.right, c.back) == doctest::Approx(0));
  CHECK(norm(cross(c.right, c.up) - c.back) == doctest::Approx(0));
  for (const image_point f : {image_point{0, 0}, {1, 1}, {-0.3, 0.7}}) {
    const view_ray s = c.ray_through(f);
    CHECK(norm(s.direction) == doctest::Approx(1));
    const image_point g = c.project(s.origin + s.direction * 3.0);
    CHECK(g.x == doctest::Approx(f.x));
    CHECK(g.y == doctest::Approx(f.y));
  }
}

}  // namespace

TEST_CASE("camera: the target is in the middle of the picture, and up points up") {
  const vec3 eye{3, 4, 5}, target{1, 1, 1};
  for (const camera& c : {perspective_camera(eye, target), orthographic_camera(eye, target, {0, 1, 0}, 2)}) {
    check_rays_and_projection(c);
    CHECK(norm(c.project(target).x * c.right + c.project(target).y * c.up) == doctest::Approx(0));
    CHECK(c.project(target + vec3{0, 0.1, 0}).y > 0);
    CHECK(c.project(target + vec3{0, 0.1, 0}).x == doctest::Approx(0));
    CHECK(c.project(target + c.right * 0.1).x > 0);
  }
  // With an angle of 90 degrees and at distance 1, the upper margin is 1 above the middle.
  const camera wide = perspective_camera({0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 90);
  CHECK(wide.project({0, 1, 0}).y == doctest::Approx(1));
  CHECK(orthographic_camera({0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 4).project({0, 2, -7}).y == doctest::Approx(1));
}

TEST_CASE("framing: all points are within the margins, and two opposite margins are touched") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double angle : {0.0, 25.0, 100.0})
    for (const double aspect : {0.5, 1.0, 1.8})
      for (const double scale : {1e-12, 1.0, 1e12})
        for (const vec3& stretch : {vec3{1, 1, 1}, vec3{5, 0.1, 0.1}, vec3{0.1, 4, 1}}) {
          std::vector<vec3> points;
          for (int i = 0; i < 200; ++i)
            points.push_back(vec3{unit(random) * stretch.x + 7, unit(random) * stretch.y, unit(random) * stretch.z} * scale);
          framing f(aspect, {.angle = angle, .margin = 0.1});
          f.add_points(points);
          const camera c = f.best();
          double x0 = 9, x1 = -9, y0 = 9, y1 = -9;
          for (const vec3& p : points) {
            CHECK(dot(p - c.eye, c.back) < 0);  // the point is in front of the camera
            const image_point q = c.project(p);
            x0 = std::min(x0, q.x), x1 = std::max(x1, q.x), y0 = std::min(y0, q.y), y1 = std::max(y1, q.y);
          }
          const double margin = 0.9;
          CHECK(x1 <= doctest::Approx(margin * aspect));
          CHECK(-x0 <= doctest::Approx(margin * aspect));
          CHECK(y1 <= doctest::Approx(margin));
          CHECK(-y0 <= doctest::Approx(margin));
          const bool fills_width = std::abs(x1 - margin * aspect) < 1e-6 && std::abs(x0 + margin * aspect) < 1e-6;
          const bool fills_height = std::abs(y1 - margin) < 1e-6 && std::abs(y0 + margin) < 1e-6;
          CHECK((fills_width || fills_height));
        }
}

TEST_CASE("framing: works for no point, one point and points on one line of sight") {
  CHECK_NOTHROW(framing(1.0).best());
  for (const double angle : {0.0, 30.0}) {
    framing single(1.0, {.angle = angle});
    single.add_points(std::vector<vec3>{{5, 5, 5}});
    const camera c = single.best();
    CHECK(dot(vec3{5, 5, 5} - c.eye, c.back) < 0);
    CHECK(c.project({5, 5, 5}).x == doctest::Approx(0));
    framing line(1.0, {.towards = {0, 0, 1}, .angle = angle});
    line.add_points(std::vector<vec3>{{0, 0, 0}, {0, 0, 3}});
    const camera d = line.best();
    CHECK(dot(vec3{0, 0, 3} - d.eye, d.back) < 0);
  }
}

TEST_CASE("camera: throws if an argument is invalid") {
  CHECK_THROWS_AS(perspective_camera({1, 1, 1}, {1, 1, 1}), invalid_argument);
  CHECK_THROWS_AS(perspective_camera({0, 1, 0}, {0, 0, 0}, {0, 1, 0}), invalid_argument);
  CHECK_THROWS_AS(perspective_camera({0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 180), invalid_argument);
  CHECK_THROWS_AS(perspective_camera({0, 0, 1}, {0, 0, 0}, {0, 0, 0}), invalid_argument);
  CHECK_THROWS_AS(orthographic_camera({0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 0), invalid_argument);
  CHECK_THROWS_AS(framing(0), invalid_argument);
  CHECK_THROWS_AS(framing(1, {.margin = 1}), invalid_argument);
  CHECK_THROWS_AS(framing(1, {.angle = -1}), invalid_argument);
}
