#include <concino/render/shapes.hpp>
#include <concino/render/smooth_normals.hpp>

#include <doctest/doctest.h>

using namespace concino;

namespace {

// Two unit squares joined at x = 0, the second rotated by an angle.
struct roof {
  std::vector<vec3> points;
  std::vector<std::uint32_t> offsets = {0, 4, 8}, corners = {0, 1, 4, 3, 1, 2, 5, 4};
  explicit roof(double degrees) {
    const double a = degrees * 3.14159265358979323846 / 180, c = std::cos(a), s = std::sin(a);
    points = {{-1, 0, 0}, {0, 0, 0}, {c, 0, s}, {-1, 1, 0}, {0, 1, 0}, {c, 1, s}};
  }
  polygon_list list() const { return {points, offsets, corners}; }
};

}  // namespace

TEST_CASE("smooth_normals: are shared below the crease angle and split above it") {
  for (const double bend : {20.0, 50.0}) {
    const roof r(bend);
    const auto n = smooth_normals(r.list(), 30);
    REQUIRE(n.size() == 8);
    const bool shared = n[1] == n[4];  // the two corners at point 1
    CHECK(shared == (bend < 30));
    CHECK(n[0][2] == doctest::Approx(1));
    if (shared) CHECK(n[1][2] == doctest::Approx(std::cos(bend / 2 * 3.14159265358979323846 / 180)));
    else CHECK(n[1][2] == doctest::Approx(1));
  }
}

TEST_CASE("smooth_normals: on a ball they point away from its centre") {
  const vec3 center{1, 2, 3};
  const drawable ball = make_balls({center}, {.radius = 0.5});
  const auto n = smooth_normals(ball.polygons(), 60);
  for (std::size_t c = 0; c < n.size(); ++c) CHECK(dot(to_vec3(n[c]), (ball.points[ball.corners[c]] - center) / 0.5) > 0.999);
}

TEST_CASE("smooth_normals: a vert with a thousand triangles is smooth in linear time") {
  std::vector<vec3> points = {{0, 0, 0.2}};
  std::vector<std::uint32_t> offsets = {0}, corners;
  const std::uint32_t n = 1000;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double a = 6.283185307179586 * i / n;
    points.push_back({std::cos(a), std::sin(a), 0});
    corners.insert(corners.end(), {0, 1 + i, 1 + (i + 1) % n});
    offsets.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  const auto normals = smooth_normals({points, offsets, corners}, 40);
  CHECK(normals[0][2] == doctest::Approx(1));
}

TEST_CASE("smooth_normals: a polygon without area has none and does not change its neighbours") {
  const std::vector<vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  const std::vector<std::uint32_t> offsets = {0, 3, 6}, corners = {0, 1, 2, 0, 3, 1};
  const auto n = smooth_normals({points, offsets, corners}, 40);
  CHECK(n[0][2] == doctest::Approx(1));
  for (const auto& x : n) CHECK(std::isfinite(x[0] + x[1] + x[2]));
}
