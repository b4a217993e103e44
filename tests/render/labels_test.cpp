#include <concino/render/labels.hpp>

#include <concino/render/detail/overlays/pixel_of.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace concino;

namespace {

constexpr rgb white{1, 1, 1};

bool inside(const pixel_box& b, const image& picture) {
  return b.left >= 0 && b.top >= 0 && b.right <= static_cast<double>(picture.width()) && b.bottom <= static_cast<double>(picture.height());
}

bool disjoint(const pixel_box& a, const pixel_box& b) {
  return a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
}

std::size_t changed(const image& a, const image& b) {
  std::size_t n = 0;
  for (std::size_t y = 0; y < a.height(); ++y)
    for (std::size_t x = 0; x < a.width(); ++x) n += !(a(x, y) == b(x, y));
  return n;
}

const camera from_front = orthographic_camera({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 2);  // y from -1 to 1 is the height of the picture

}  // namespace

TEST_CASE("pixel_of: the middle of the picture is what the camera looks at") {
  const auto middle = detail::pixel_of(from_front, 400, 300, {0, 0, 0});
  REQUIRE(middle);
  CHECK(middle->x == doctest::Approx(200));
  CHECK(middle->y == doctest::Approx(150));
  const auto above = detail::pixel_of(from_front, 400, 300, {0.5, 1, 0});
  REQUIRE(above);
  CHECK(above->x == doctest::Approx(275));
  CHECK(above->y == doctest::Approx(0));
  CHECK(!detail::pixel_of(perspective_camera({0, 0, 5}, {0, 0, 0}), 400, 300, {0, 0, 6}));
  CHECK(!detail::pixel_of(from_front, 400, 300, {0, std::numeric_limits<double>::quiet_NaN(), 6}));
}

TEST_CASE("draw_labels: a text is to the right of its point, on its background") {
  image picture(400, 300, {0, 0, 1});
  const point_label label{{0, 0, 0}, "point"};
  const auto boxes = draw_labels(picture, from_front, {&label, 1}, {.size = 20, .background = {1, 1, 0}, .background_opacity = 1});
  REQUIRE(boxes.size() == 1);
  CHECK((boxes[0].left > 200 && boxes[0].left < 220));
  CHECK((boxes[0].top < 150 && boxes[0].bottom > 150));
  CHECK(picture(static_cast<std::size_t>(boxes[0].left) + 1, 150) == rgb{1, 1, 0});
  CHECK(lightness(picture(199, 149)) < 20);  // the dot
  CHECK(picture(190, 150) == rgb{0, 0, 1});
}

TEST_CASE("draw_labels: texts stay in the picture, and overlap neither each other nor a point") {
  image picture(500, 300, white);
  std::vector<point_label> labels;
  for (int i = 0; i < 30; ++i) labels.push_back({{1.6 * std::sin(i * 1.7), 0.98 * std::cos(i * 2.9), 0}, "vert " + std::to_string(i)});
  for (const double x : {-1.66, 1.66})
    for (const double y : {-0.99, 0.99}) labels.push_back({{x, y, 0}, "Åg"});
  const auto boxes = draw_labels(picture, from_front, labels);
  int drawn = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!(boxes[i].width() > 0)) continue;
    ++drawn;
    CHECK(inside(boxes[i], picture));
    for (std::size_t j = 0; j < i; ++j)
      if (boxes[j].width() > 0) CHECK(disjoint(boxes[i], boxes[j]));
    for (const point_label& l : labels) {
      const auto p = *detail::pixel_of(from_front, 500, 300, l.point);
      CHECK(!(p.x > boxes[i].left && p.x < boxes[i].right && p.y > boxes[i].top && p.y < boxes[i].bottom));
    }
  }
  CHECK(drawn >= 33);
}

TEST_CASE("draw_labels: many at one place have lines; without room some are left out, and the result says which") {
  std::vector<point_label> labels(12, {{0, 0, 0}, "the same place"});
  image picture(600, 400, white);
  for (const pixel_box& b : draw_labels(picture, from_front, labels)) CHECK(b.width() > 0);
  image small(150, 60, white);
  int drawn = 0;
  for (const pixel_box& b : draw_labels(small, from_front, labels)) drawn += b.width() > 0;
  CHECK(drawn > 0);
  CHECK(drawn < 12);
}

TEST_CASE("draw_labels: points that the camera does not see have no label; no points, no change") {
  image picture(400, 300, white);
  const std::vector<point_label> hidden = {
      {{0, 0, 9}, "behind"}, {{50, 0, 0}, "outside"}, {{std::numeric_limits<double>::infinity(), 0, 0}, "nowhere"}};
  for (const pixel_box& b : draw_labels(picture, perspective_camera({0, 0, 5}, {0, 0, 0}), hidden)) CHECK(b.width() == 0);
  CHECK(draw_labels(picture, from_front, {}).empty());
  CHECK(changed(picture, image(400, 300, white)) == 0);
  const point_label empty{{0, 0, 0}, ""};
  CHECK(draw_labels(picture, from_front, {&empty, 1}, {.dots = false})[0].width() == 0);
  CHECK(changed(picture, image(400, 300, white)) == 0);
  image none;
  draw_labels(none, from_front, hidden);
}

TEST_CASE("draw_labels: errors") {
  image picture(40, 30, white);
  CHECK_THROWS_WITH_AS(draw_labels(picture, from_front, {}, {.size = -2}), "draw_labels: size must be 0 to 65535",
                       invalid_argument);
  CHECK_THROWS_WITH_AS(draw_labels(picture, from_front, {}, {.background_opacity = 3}), "draw_labels: background_opacity must be in [0, 1]",
                       invalid_argument);
}
