#include <concino/render/axes.hpp>

#include <concino/render/detail/overlays/pixel_of.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <utility>
#include <vector>

using namespace concino;

namespace {

constexpr rgb white{1, 1, 1};
constexpr box around{{-1, 0, -0.5}, {1, 0.8, 0.7}};

std::size_t drawn(const image& picture, const pixel_box& b) {
  std::size_t n = 0;
  for (std::size_t y = 0; y < picture.height(); ++y)
    for (std::size_t x = 0; x < picture.width(); ++x) {
      const double cx = static_cast<double>(x) + 0.5, cy = static_cast<double>(y) + 0.5;
      n += cx > b.left && cx < b.right && cy > b.top && cy < b.bottom && !(picture(x, y) == white);
    }
  return n;
}
std::size_t drawn(const image& picture) {
  return drawn(picture, {0, 0, static_cast<double>(picture.width()), static_cast<double>(picture.height())});
}

/// The pixels of the outermost rows and columns that are not white.
std::size_t at_edges(const image& picture) {
  const double w = static_cast<double>(picture.width()), h = static_cast<double>(picture.height());
  return drawn(picture) - drawn(picture, {1, 1, w - 1, h - 1});
}

camera framed(const vec3& towards, double angle, double aspect = 4.0 / 3, double margin = 0.25) {
  framing f(aspect, {.towards = towards, .angle = angle, .margin = margin});
  std::vector<vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? around.max.x : around.min.x, i & 2 ? around.max.y : around.min.y, i & 4 ? around.max.z : around.min.z});
  f.add_points(corners);
  return f.best();
}

}  // namespace

TEST_CASE("draw_axes: seen from the front, x runs along the lower edge of the box and y along the left one") {
  image picture(400, 300, white);
  const camera c = orthographic_camera({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 4);  // 75 pixels are 1
  draw_axes(picture, c, around, {.directions = false});
  CHECK(drawn(picture, {126, 91, 275, 149}) == 0);  // the inside of the box
  CHECK(drawn(picture, {125, 149, 275, 151}) > 140);
  CHECK(drawn(picture, {124, 90, 126, 150}) > 55);
  CHECK(drawn(picture, {276, 0, 400, 149}) == 0);
  // The ticks of 0 and 0.5 on x, and white between them
  CHECK(drawn(picture, {199, 151, 201, 154}) > 0);
  CHECK(drawn(picture, {236.5, 151, 238.5, 154}) > 0);
  CHECK(drawn(picture, {210, 151, 228, 154}) == 0);
  CHECK(drawn(picture, {190, 155, 210, 168}) > 10);  // 0.0
}

TEST_CASE("draw_axes: numbers surround the box, from every side, and nothing is cut off") {
  for (const vec3& towards : {vec3{0.5, 0.35, 1}, {1, 1, 1}, {-1, -0.4, 0.3}, {-0.2, 2, 0.3}, {0.02, 0.01, -1}, {1, 0, 0}})
    for (const double angle : {25.0, 0.0}) {
      const camera c = framed(towards, angle);
      image picture(400, 300, white), arrows = picture;
      draw_axes(picture, c, around, {.directions = false});
      CHECK(drawn(picture) > 400);
      const auto middle = detail::pixel_of(c, 400, 300, {0, 0.4, 0.1});
      CHECK(drawn(picture, {middle->x - 15, middle->y - 15, middle->x + 15, middle->y + 15}) == 0);
      CHECK(at_edges(picture) == 0);
      draw_axes(arrows, c, around, {.numbers = false});
      CHECK(drawn(arrows, {0, 200, 100, 300}) == drawn(arrows));
      CHECK(drawn(arrows) > 60);
      CHECK(at_edges(arrows) == 0);
    }
}

TEST_CASE("draw_axes: where the box fills the picture, numbers are moved inside") {
  for (const auto& [width, height] : {std::pair<std::size_t, std::size_t>{400, 300}, {80, 60}, {300, 40}, {20, 90}}) {
    image picture(width, height, white);
    draw_axes(picture, framed({0.5, 0.35, 1}, 25, static_cast<double>(width) / static_cast<double>(height), 0.02), around,
              {.names = {"length Åg", "height", "depth"}});
    CHECK(drawn(picture) > 10);
  }
  image picture(400, 300, white);
  draw_axes(picture, orthographic_camera({0, 0, 5}, {0, 0.4, 0}, {0, 1, 0}, 0.9), around, {.directions = false});
  CHECK(drawn(picture, {0, 280, 400, 300}) > 50);
}

TEST_CASE("draw_axes: arrows point where the axes do") {
  image picture(400, 300, white);
  draw_axes(picture, orthographic_camera({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 4), {}, {.numbers = false, .size = 20});
  // The origin is 80 pixels from the corner; the arrow of x is red and runs to the right, that of y green and upward.
  const rgb red = picture(100, 220), green = picture(80, 190);
  CHECK((red.r > red.g && red.r > red.b && !(red == white)));
  CHECK((green.g > green.r && green.g > green.b && !(green == white)));
  CHECK(picture(60, 220) == white);
  CHECK(picture(80, 240) == white);
}

TEST_CASE("draw_axes: no numbers for an empty box, one behind the camera or around it; flat boxes have two axes") {
  const double inf = std::numeric_limits<double>::infinity();
  const camera near = perspective_camera({0, 0.4, 0.1}, {0, 0, -5});
  for (const box& b : {box{}, box{{0, 0, -inf}, {1, 1, 1}}, around}) {
    image picture(200, 150, white);
    draw_axes(picture, near, b, {.directions = false});
    CHECK(drawn(picture) == 0);
  }
  image flat(400, 300, white), single = flat;
  draw_axes(flat, framed({0.5, 0.35, 1}, 25), {{-1, 0, 0}, {1, 0.8, 0}}, {.directions = false});
  CHECK(drawn(flat) > 300);
  draw_axes(single, framed({0.5, 0.35, 1}, 25), {{0, 0, 0}, {0, 0, 0}}, {.directions = false});
  CHECK(drawn(single) == 0);
}

TEST_CASE("draw_axes: errors") {
  image picture(40, 30, white);
  const camera c = framed({0, 0, 1}, 25);
  CHECK_THROWS_WITH_AS(draw_axes(picture, c, around, {.size = -1}), "draw_axes: size must be 0 to 65535", invalid_argument);
  CHECK_THROWS_WITH_AS(draw_axes(picture, c, around, {.ticks = 0}), "draw_axes: ticks must be 1 to 100", invalid_argument);
  CHECK(drawn(picture) == 0);
  image none;
  draw_axes(none, c, around);
}
