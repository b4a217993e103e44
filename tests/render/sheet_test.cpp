#include <concino/render/sheet.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace concino;

namespace {

constexpr rgb red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1}, white{1, 1, 1};

std::size_t pixels_of(const image& picture, const rgb& color) {
  std::size_t n = 0;
  for (std::size_t y = 0; y < picture.height(); ++y)
    for (std::size_t x = 0; x < picture.width(); ++x) n += picture(x, y) == color;
  return n;
}

}  // namespace

TEST_CASE("make_sheet: rows and columns, with gaps between and around them") {
  const std::vector<image> pictures = {image(30, 20, red), image(30, 20, green), image(30, 20, blue)};
  const image sheet = make_sheet(pictures, {.columns = 2, .gap = 5});
  CHECK(sheet.width() == 2 * 30 + 3 * 5);
  CHECK(sheet.height() == 2 * 20 + 3 * 5);
  CHECK(sheet(4, 5) == white);
  CHECK(sheet(5, 5) == red);
  CHECK(sheet(34, 24) == red);
  CHECK(sheet(35, 5) == white);
  CHECK(sheet(40, 5) == green);
  CHECK(sheet(5, 30) == blue);
  CHECK(sheet(40, 30) == white);
  CHECK(pixels_of(sheet, red) == 600);
  CHECK(make_sheet(pictures, {.columns = 9, .gap = 0}).width() == 90);
  CHECK(make_sheet(pictures, {.columns = 1, .gap = 0, .background = red}).height() == 60);
}

TEST_CASE("make_sheet: without a number of columns the sheet is about square") {
  CHECK(make_sheet(std::vector<image>(4, image(30, 30)), {.gap = 0}).width() == 60);
  CHECK(make_sheet(std::vector<image>(3, image(300, 30)), {.gap = 0}).width() == 300);
  CHECK(make_sheet(std::vector<image>(3, image(30, 300)), {.gap = 0}).width() == 90);
  CHECK(make_sheet(std::vector<image>(1, image(3, 3)), {.gap = 0}).width() == 3);
}

TEST_CASE("make_sheet: pictures of several sizes are whole, in the middle of their cells") {
  const std::vector<image> pictures = {image(10, 40, red), image(50, 20, green), image(30, 30, blue)};
  const image sheet = make_sheet(pictures, {.columns = 2, .gap = 1});
  CHECK(sheet.width() == 30 + 50 + 3);
  CHECK(sheet.height() == 40 + 30 + 3);
  CHECK(sheet(10, 5) == white);
  CHECK(sheet(11, 5) == red);
  CHECK(sheet(40, 10) == white);
  CHECK(sheet(40, 11) == green);
  CHECK(pixels_of(sheet, red) == 400);
  CHECK(pixels_of(sheet, green) == 1000);
  CHECK(pixels_of(sheet, blue) == 900);
}

TEST_CASE("make_sheet: captions and a title lie between the pictures, never on them") {
  const std::vector<image> pictures(4, image(100, 60, green));
  const std::vector<std::string> captions = {"one", "two Åg", "", "a caption that is much longer than its picture\nof two lines"};
  const image plain = make_sheet(pictures, {.columns = 2}),
              sheet = make_sheet(pictures, {.columns = 2, .captions = captions, .title = "A title"});
  CHECK(sheet.height() > plain.height() + 40);
  CHECK(sheet.width() == plain.width());
  CHECK(pixels_of(sheet, green) == 4 * 6000);
  std::size_t others = 0;
  for (std::size_t y = 0; y < sheet.height(); ++y)
    for (std::size_t x = 0; x < sheet.width(); ++x) {
      const bool letter = !(sheet(x, y) == green) && !(sheet(x, y) == white);
      others += letter;
      if (x == 0 || y == 0 || x + 1 == sheet.width() || y + 1 == sheet.height()) CHECK(!letter);
    }
  CHECK(others > 300);
}

TEST_CASE("make_sheet: opacities") {
  image clear(10, 10, red);
  clear.add_opacity(0.5f);
  const image both = make_sheet(std::vector<image>{clear, image(10, 10, blue)}, {.columns = 2, .gap = 2});
  CHECK(!both.has_opacity());
  CHECK(both(2, 2) == rgb{1, 0.5f, 0.5f});
  const image sheet = make_sheet(std::vector<image>{clear, clear}, {.columns = 2, .gap = 2});
  CHECK(sheet.has_opacity());
  CHECK(sheet(2, 2) == red);
  CHECK(sheet.opacity(2, 2) == 0.5f);
  CHECK(sheet.opacity(0, 0) == 0);
}

TEST_CASE("make_sheet: errors") {
  const std::vector<image> pictures(2, image(10, 10));
  CHECK_THROWS_WITH_AS(make_sheet({}), "make_sheet: there is no picture", invalid_argument);
  CHECK_THROWS_WITH_AS(make_sheet(std::vector<image>{image(2, 2), image()}), "make_sheet: picture 1 has no pixels", invalid_argument);
  CHECK_THROWS_WITH_AS(make_sheet(pictures, {.captions = {"a", "b", "c"}}), "make_sheet: 3 captions for 2 pictures", invalid_argument);
  CHECK_THROWS_WITH_AS(make_sheet(pictures, {.size = -1}), "make_sheet: size must be 0 to 65535", invalid_argument);
  CHECK_THROWS_WITH_AS(make_sheet(pictures, {.gap = 65536}), "make_sheet: gap must be at most 65535 pixels", invalid_argument);
  CHECK_THROWS_WITH_AS(make_sheet(pictures, {.columns = 2, .gap = 60000}),
                       "make_sheet: the sheet would have 180020 x 120010 pixels, more than 65535 along an axis", invalid_argument);
}
