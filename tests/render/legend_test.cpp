#include <concino/render/legend.hpp>

#include <concino/render/detail/overlays/ticks.hpp>
#include <concino/render/label_colors.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace concino;

namespace {

constexpr rgb white{1, 1, 1};

std::string texts(const std::vector<detail::tick>& ticks) {
  std::string s;
  for (const auto& t : ticks) s += (s.empty() ? "" : "|") + t.text;
  return s;
}
std::string texts(double low, double high, int count = 6) { return texts(detail::round_ticks(low, high, count)); }

bool white_outside(const image& picture, const pixel_box& box) {
  for (std::size_t y = 0; y < picture.height(); ++y)
    for (std::size_t x = 0; x < picture.width(); ++x) {
      const double cx = static_cast<double>(x) + 0.5, cy = static_cast<double>(y) + 0.5;
      if ((cx < box.left - 1 || cx > box.right + 1 || cy < box.top - 1 || cy > box.bottom + 1) && !(picture(x, y) == white)) return false;
    }
  return true;
}

bool holds(const image& picture, const rgb& color) {
  for (std::size_t y = 0; y < picture.height(); ++y)
    for (std::size_t x = 0; x < picture.width(); ++x)
      if (srgb_bytes(picture(x, y)) == srgb_bytes(color)) return true;
  return false;
}

/// Powers grow from 0 to 250, most of them near 0.
value_scale uneven_scale() {
  std::vector<double> values;
  for (int i = 0; i <= 1000; ++i) values.push_back(250 * std::pow(i / 1000.0, 6));
  return value_scale::equalized(values, 0.8);
}

}  // namespace

TEST_CASE("round_ticks: multiples of 1, 2 and 5 times a power of ten") {
  CHECK(texts(0, 1) == "0.0|0.2|0.4|0.6|0.8|1.0");
  CHECK(texts(0, 7.3) == "0|2|4|6");
  CHECK(texts(-1, 1) == "−1.0|−0.5|0.0|0.5|1.0");
  CHECK(texts(0.12, 0.95) == "0.2|0.4|0.6|0.8");
  CHECK(texts(99.97, 100.02) == "99.97|99.98|99.99|100.00|100.01|100.02");
  CHECK(texts(0, 1, 1) == "0|1");
}

TEST_CASE("round_ticks: powers of ten where numbers are long") {
  CHECK(texts(-3.2e-5, 1.05e-4) == "−2·10⁻⁵|0|2·10⁻⁵|4·10⁻⁵|6·10⁻⁵|8·10⁻⁵|10⁻⁴");
  CHECK(texts(1e9, 2.5e9) == "10⁹|1.5·10⁹|2·10⁹|2.5·10⁹");
  CHECK(texts(0, 100000) == "0|20000|40000|60000|80000|100000");
  CHECK(texts(1000000.1, 1000000.3, 2) == "1000000.1|1000000.2|1000000.3");
  CHECK(texts(-1e308, 1e308, 5) == "−10³⁰⁸|−5·10³⁰⁷|0|5·10³⁰⁷|10³⁰⁸");
}

TEST_CASE("round_ticks: one number if all are equal; none if they are not finite") {
  CHECK(texts(3, 3) == "3");
  CHECK(texts(0, 0) == "0");
  CHECK(texts(0.1, 0.1) == "0.1");
  CHECK(texts(0, 1e-310) == "0");
  CHECK(texts(1, 1 + 1e-15) == "1");
  CHECK(texts(0, std::numeric_limits<double>::infinity()).empty());
  CHECK(texts(detail::round_ticks(value_scale{}, 5)) == texts(0, 1, 5));
}

TEST_CASE("round_ticks: on a scale that is not linear, numbers are round and at about equal distances") {
  const value_scale scale = uneven_scale();
  const auto ticks = detail::round_ticks(scale, 6);
  REQUIRE(ticks.size() >= 5);
  for (std::size_t k = 1; k < ticks.size(); ++k) {
    const double distance = scale(ticks[k].value) - scale(ticks[k - 1].value);
    CHECK(distance > 0.09);
    CHECK(distance < 0.36);
    CHECK(ticks[k].text.size() <= 5);
  }
}

TEST_CASE("draw_legend: a bar of the map with its ends, inside the picture") {
  image picture(400, 300, white);
  appearance look;
  look.scale = value_scale::linear(-2, 7);
  const pixel_box box = draw_legend(picture, look, {.title = "T", .unit = "K"});
  CHECK(white_outside(picture, box));
  CHECK(box.left > 200);
  CHECK(box.right < 395);
  const pixel_box same = legend_box(400, 300, look, {.title = "T", .unit = "K"});
  CHECK((same.left == box.left && same.right == box.right && same.top == box.top && same.bottom == box.bottom));
  // Down the middle of the bar colours go through the map.
  const auto x = static_cast<std::size_t>(box.left) + 4;
  std::vector<double> light;
  for (std::size_t y = 0; y < 300; ++y)
    if (const rgb& c = picture(x, y); !(c == white)) light.push_back(lightness(c));
  std::vector<double> bar(light.end() - 140, light.end() - 5);
  for (std::size_t i = 1; i < bar.size(); ++i) CHECK(bar[i] <= bar[i - 1] + 0.1);
  CHECK(bar.front() > lightness(look.map(0.9)));
  CHECK(bar.back() < lightness(look.map(0.1)));
}

TEST_CASE("draw_legend: bands, iso-lines and the colour of missing values") {
  appearance look;
  look.no_value = {1, 0, 1};
  image plain(400, 300, white), bands = plain, lines = plain, missing = plain;
  const pixel_box box = draw_legend(plain, look);
  look.isobands = 5;
  draw_legend(bands, look);
  look.isobands = 0;
  look.isolines = 8;
  draw_legend(lines, look);
  const auto x = static_cast<std::size_t>(box.left) + 4;
  const auto changes = [&](const image& picture) {
    int n = 0;
    for (std::size_t y = 1; y < 300; ++y) n += (picture(x, y) == plain(x, y)) != (picture(x, y - 1) == plain(x, y - 1));
    return n;
  };
  CHECK(changes(bands) == 10);
  CHECK(changes(lines) == 16);
  draw_legend(missing, look, {.no_value = "none"});
  CHECK(!holds(plain, look.no_value));
  CHECK(holds(missing, look.no_value));
}

TEST_CASE("draw_legend: names of labels") {
  appearance look;
  look.labels = true;
  image picture(400, 300, white);
  CHECK(white_outside(
      picture, draw_legend(picture, look, {.title = "material", .place = legend_place::left, .labels = {"steel", "iron", "rubber"}})));
  for (std::size_t k = 0; k < 4; ++k) CHECK(holds(picture, label_color(k)) == (k < 3));
  CHECK(picture(399, 150) == white);
  image numbers(400, 300, white);
  look.scale = value_scale::linear(2, 5);
  CHECK(white_outside(numbers, draw_legend(numbers, look)));
  for (std::size_t k = 0; k < 8; ++k) CHECK(holds(numbers, label_color(k)) == (k >= 2 && k <= 5));
  image many(400, 300, white);
  look.scale = value_scale::linear(0, 1e6);
  CHECK(white_outside(many, draw_legend(many, look, {.title = "a\nb"})));
  image none(400, 300, white);
  look.scale = value_scale::linear(0.5, 0.6);
  draw_legend(none, look);
  CHECK(none == image(400, 300, white));
}

TEST_CASE("draw_legend: nothing is cut off, however small the picture") {
  appearance look;
  look.scale = uneven_scale();
  for (const auto& [width, height] : {std::pair<std::size_t, std::size_t>{60, 40}, {30, 200}, {500, 20}, {5, 5}, {1, 1}, {800, 600}})
    for (const legend_place place : {legend_place::left, legend_place::right}) {
      image picture(width, height, white);
      const pixel_box box =
          draw_legend(picture, look, {.title = "a long title of a legend Åg", .unit = "m/s²", .place = place, .no_value = "no value"});
      CHECK(white_outside(picture, box));
      CHECK((box.left >= 0 && box.top >= 0 && box.right <= static_cast<double>(width) && box.bottom <= static_cast<double>(height)));
      if (width > 20) CHECK(!(picture == image(width, height, white)));
    }
}

TEST_CASE("draw_legend: errors") {
  image picture(100, 100, white);
  const appearance look;
  CHECK_THROWS_WITH_AS(draw_legend(picture, look, {.size = -1}), "draw_legend: size must be 0 to 65535", invalid_argument);
  CHECK_THROWS_WITH_AS(draw_legend(picture, look, {.ticks = 0}), "draw_legend: ticks must be 1 to 100", invalid_argument);
  CHECK_THROWS_WITH_AS(legend_box(100, 100, look, {.ticks = 101}), "legend_box: ticks must be 1 to 100", invalid_argument);
  CHECK(picture == image(100, 100, white));
  image none;
  draw_legend(none, look);
  CHECK(legend_options{.unit = "K"}.wanted());
  CHECK(legend_options{.show = true}.wanted());
  CHECK(!legend_options{}.wanted());
}

TEST_CASE("draw_title: in the middle of the upper edge, and never wider than the picture") {
  image picture(400, 300, white);
  const pixel_box box = draw_title(picture, "A title");
  CHECK(white_outside(picture, box));
  CHECK((box.left + box.right) / 2 == doctest::Approx(200).epsilon(0.01));
  CHECK((box.top > 2 && box.bottom < 40));
  image narrow(60, 300, white);
  const pixel_box all = draw_title(narrow, "A title that is too long for this picture");
  CHECK((all.left > 0 && all.right < 60));
  CHECK(white_outside(narrow, all));
  draw_title(narrow, "");
  image none;
  draw_title(none, "a");
}
