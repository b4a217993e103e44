#include <concino/render/text.hpp>

#include <concino/geometry/orientation.hpp>
#include <concino/render/detail/image/coverage.hpp>
#include <concino/render/detail/text/font.hpp>
#include <concino/render/detail/text/outline_triangles.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace concino;

namespace {

constexpr rgb white{1, 1, 1};

/// The area that black covers on a white picture, in pixels.
double ink(const image& picture) {
  double sum = 0;
  for (std::size_t y = 0; y < picture.height(); ++y)
    for (std::size_t x = 0; x < picture.width(); ++x) sum += 1 - static_cast<double>(picture(x, y).g);
  return sum;
}

image written(std::string_view text, const text_options& options = {}) {
  image picture(600, 200, white);
  draw_text(picture, text, {20, 100}, options);
  return picture;
}

double signed_area(const std::vector<vec3>& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += cross(p[i], p[(i + 1) % p.size()]).z / 2;
  return sum;
}

}  // namespace

TEST_CASE("coverage: a polygon anywhere covers its area, also where the picture ends") {
  const pixel_position triangle[] = {{3.25, 2.5}, {11.75, 4.125}, {5.5, 13.625}};
  image picture(16, 16, white);
  detail::fill_polygon(picture, triangle, {});
  CHECK(ink(picture) == doctest::Approx((8.5 * 11.125 - 2.25 * 1.625) / 2).epsilon(1e-5));
  image box(8, 8, white);
  detail::fill_box(box, {-3, 1.5, 2.25, 100}, {});
  CHECK(ink(box) == doctest::Approx(2.25 * 6.5));
  CHECK(box(0, 0) == white);
  CHECK(box(0, 1).r == doctest::Approx(0.5));
  CHECK(box(2, 4).r == doctest::Approx(0.75));
  CHECK(box(3, 4) == white);
  // A square on its corner around the corner of the picture: a quarter of it is inside.
  image corner(10, 10, white);
  const pixel_position diamond[] = {{-4, 0}, {0, -4}, {4, 0}, {0, 4}};
  detail::fill_polygon(corner, diamond, {});
  CHECK(ink(corner) == doctest::Approx(8));
  image none(5, 5, white);
  const double far = 1e308, nan = std::numeric_limits<double>::quiet_NaN();
  detail::draw_line(none, {-far, -far}, {far, far}, 1, {});
  detail::draw_line(none, {nan, 0}, {1, nan}, 1, {});
  detail::fill_box(none, {nan, nan, nan, nan}, {});
  detail::fill_polygon(none, std::vector<pixel_position>{{far, 0}, {-far, far}, {-far, -far}}, {}, 0);
  CHECK(none == image(5, 5, white));
  image line(20, 20, white);
  detail::draw_line(line, {4, 4}, {10, 12}, 1.5, {});
  detail::draw_line(line, {4, 4}, {4, 4}, 1.5, {});
  CHECK(ink(line) == doctest::Approx(15).epsilon(1e-5));
}

TEST_CASE("outline_triangles: several holes in a row, a part in a hole, and holes of nothing") {
  const auto square = [](double x, double y, double size, bool hole) {
    std::vector<vec3> s = {{x, y, 0}, {x + size, y, 0}, {x + size, y + size, 0}, {x, y + size, 0}};
    if (hole) std::swap(s[1], s[3]);
    return s;
  };
  std::vector<std::vector<vec3>> outlines = {square(0, 0, 10, false), square(1, 1, 2, true),  square(4, 1, 2, true),  square(7, 1, 2, true),
                                             square(4, 4, 4, true),   square(5, 5, 2, false), square(20, 0, 1, true), {}};
  double area = 0;
  for (const auto& [a, b, c] : detail::outline_triangles(outlines)) {
    CHECK(orient2d(a, b, c) > 0);
    area += cross(b - a, c - a).z / 2;
    const vec3 middle = (a + b + c) / 3;
    CHECK(!(middle.x > 1 && middle.x < 3 && middle.y > 1 && middle.y < 3));
  }
  CHECK(area == doctest::Approx(100 - 3 * 4 - 16 + 4));
}

TEST_CASE("font: the triangles of each character cover its outlines") {
  int characters = 0;
  for (char32_t c = 0x20; c < 0x2800; ++c) {
    if (c == 0x450) c = 0x2000;  // nothing in between
    const auto glyph = detail::glyph_of(c, 0.01);
    CHECK(glyph.advance > 0.1);
    double area = 0, filled = 0;
    for (const auto& contour : glyph.contours) area += signed_area(contour);
    for (const auto& [a, b, d] : detail::outline_triangles(glyph.contours)) filled += cross(b - a, d - a).z / 2;
    CHECK(filled == doctest::Approx(area).epsilon(1e-9));
    ++characters;
  }
  CHECK(characters > 3000);
}

TEST_CASE("draw_text: letters cover their area, at any place and size") {
  for (const double size : {9.0, 30.5, 100.0})
    for (const char* text : {"B", "8%", "Ωµ@", "ä"}) {
      double area = 0;
      const std::string s = text;
      for (const char32_t c : detail::characters_of(s.data(), s.size()))
        for (const auto& contour : detail::glyph_of(c, 0.05 / size).contours) area += signed_area(contour);
      CHECK(ink(written(text, {.size = size})) == doctest::Approx(area * size * size).epsilon(1e-4));
    }
}

TEST_CASE("draw_text: letters stand on the baseline, capital letters are 0.729 em high") {
  const pixel_box h = text_box("H", {10, 50}, {.size = 100});
  CHECK(h.bottom == doctest::Approx(50));
  CHECK(h.top == doctest::Approx(50 - 72.9).epsilon(1e-2));
  CHECK(h.left > 10);
  CHECK(h.right < 10 + text_width("H", 100));
  CHECK(text_box("H", {10, 50}, {.size = 100, .level = text_level::top}).top == doctest::Approx(50).epsilon(1e-3));
  const pixel_box middle = text_box("H", {10, 50}, {.size = 100, .align = text_align::middle, .level = text_level::middle});
  CHECK((middle.top + middle.bottom) / 2 == doctest::Approx(50).epsilon(1e-3));
  CHECK((middle.left + middle.right) / 2 == doctest::Approx(10).epsilon(1e-2));
  CHECK(text_box("g", {10, 50}, {.size = 100, .align = text_align::right, .level = text_level::bottom}).bottom <= 50);
  CHECK(text_box("g", {10, 50}, {.size = 100, .align = text_align::right}).right <= 10);
  // Black below the left stem, white beside it
  image picture(100, 60, white);
  const pixel_box box = draw_text(picture, "H", {10, 50}, {.size = 50});
  const auto x = static_cast<std::size_t>(box.left) + 2;
  CHECK(picture(x, 30) == rgb{});
  CHECK(picture(x + 10, 20) == white);
  CHECK(picture(x, 52) == white);
}

TEST_CASE("text_width: widths add up, and grow with the size") {
  CHECK(text_width("", 20) == 0);
  CHECK(text_width("ab", 20) == doctest::Approx(text_width("a", 20) + text_width("b", 20)));
  CHECK(text_width("ab", 40) == doctest::Approx(2 * text_width("ab", 20)));
  CHECK(text_width("abc\nx", 20) == text_width("abc", 20));
  CHECK(text_width("0", 20) == text_width("7", 20));  // digits are equally wide, so numbers can stand below one another
}

TEST_CASE("draw_text: lines are 1.2 em apart") {
  const pixel_box one = text_box("H", {0, 0}, {.size = 10}), two = text_box("H\nH", {0, 0}, {.size = 10});
  CHECK(two.bottom == doctest::Approx(one.bottom + 12));
  CHECK(two.top == one.top);
  CHECK(ink(written("a\n\na\n")) == doctest::Approx(2 * ink(written("a"))));
  CHECK(text_box("H\nH", {0, 0}, {.size = 10, .level = text_level::middle}).bottom == doctest::Approx(6 + 3.645).epsilon(1e-3));
}

TEST_CASE("draw_text: what is not UTF-8, and unknown characters, are boxes") {
  const image box = written("\xef\xbf\xbd");
  CHECK(ink(box) > 10);
  CHECK(written("\xe4\xb8\xad") == box);                      // a Chinese character
  CHECK(written("\xff") == box);                              // no first byte
  CHECK(written("\x80") == box);                              // not at the beginning
  CHECK(written("\xce") == box);                              // cut off
  CHECK(written("\xc0\x80") == written("\xff\xff"));          // 0 in two bytes
  CHECK(written("\xed\xa0\x80") == written("\xff\xff\xff"));  // half of a pair
  CHECK(written("\xf5\x80\x80\x80") == written("\xff\xff\xff\xff"));
  CHECK(written("\x01") == box);
  CHECK(written("\xce\xb1") != box);
  CHECK(written("a\tb") == written("a b"));
}

TEST_CASE("draw_text: nothing is cut off at the edges of the picture") {
  const double all = ink(written("Ågj|", {.size = 40}));
  for (const double x : {-1e9, -3.0, 0.0, 90.0, 200.0, 1e9})
    for (const double y : {-1e9, 0.0, 3.0, 95.0, 100.0, 1e9})
      for (const text_align align : {text_align::left, text_align::right}) {
        image picture(140, 100, white);
        const pixel_box box = draw_text(picture, "Ågj|", {x, y}, {.size = 40, .align = align});
        CHECK(ink(picture) == doctest::Approx(all).epsilon(1e-4));
        CHECK((box.left >= -1e-6 && box.right <= 140 + 1e-6 && box.top >= -1e-6 && box.bottom <= 100 + 1e-6));
      }
  image small(30, 20, white);
  const pixel_box box = draw_text(small, "a long text", {10, 10}, {.size = 40});
  CHECK(box.width() == doctest::Approx(30));
  CHECK(ink(small) > 10);
  image cut(140, 100, white);
  draw_text(cut, "Ågj|", {100, 100}, {.size = 40, .keep_inside = false});
  CHECK(ink(cut) < 0.8 * all);
  const image before = cut;
  for (const double far : {-1e9, 1e9, 1e300}) draw_text(cut, "Ågj|", {far, -far}, {.size = 40, .keep_inside = false});
  CHECK(cut == before);
}

TEST_CASE("draw_text: colour and opacity, also where the picture is transparent") {
  image picture(100, 100, white);
  draw_text(picture, "—", {0, 50}, {.size = 100, .color = {1, 0, 0}, .opacity = 0.5});
  const auto row = static_cast<std::size_t>(text_box("—", {0, 50}, {.size = 100}).top) + 2;
  CHECK(picture(50, row).r == 1);
  CHECK(picture(50, row).g == doctest::Approx(0.5));
  image empty(100, 100, white);
  empty.add_opacity(0);
  draw_text(empty, "—", {0, 50}, {.size = 100, .color = {1, 0, 0}});
  CHECK(empty(50, row) == rgb{1, 0, 0});
  CHECK(empty.opacity(50, row) == 1);
  CHECK(empty.opacity(50, row + 20) == 0);
}

TEST_CASE("draw_text: errors; nothing is drawn for an empty text or into an empty picture") {
  image picture(10, 10, white);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS(draw_text(picture, "a", {0, 0}, {.size = 0}),
                       "draw_text: the size of the text must be above 0 and at most 1000000 pixels", invalid_argument);
  CHECK_THROWS_AS(draw_text(picture, "a", {0, 0}, {.size = nan}), invalid_argument);
  CHECK_THROWS_WITH_AS(draw_text(picture, "a", {0, nan}), "draw_text: the position is not finite", invalid_argument);
  CHECK_THROWS_WITH_AS(draw_text(picture, "a", {0, 0}, {.opacity = 2}), "draw_text: opacity must be in [0, 1]", invalid_argument);
  CHECK_THROWS_AS(text_box("a", {nan, 0}), invalid_argument);
  CHECK_THROWS_AS(text_width("a", -1), invalid_argument);
  CHECK(ink(picture) == 0);
  for (const char* text : {"", " ", "\n\n"}) {
    const pixel_box box = draw_text(picture, text, {3, 4});
    CHECK((box.left == 3 && box.right == 3));
  }
  CHECK(ink(picture) == 0);
  image none;
  draw_text(none, "a", {3, 4});
}
