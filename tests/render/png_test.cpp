#include <concino/render/png.hpp>

#include <support/png_reader.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <limits>

using namespace concino;
using concino::testing::read_png;

namespace {

image gradient(std::size_t width, std::size_t height) {
  image picture(width, height);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x)
      picture(x, y) = srgb(static_cast<float>(x) / static_cast<float>(width), static_cast<float>(y) / static_cast<float>(height), 0.5f);
  return picture;
}

void check_png(const image& picture) {
  const auto bytes = png_bytes(picture);
  const auto png = read_png(bytes);
  CHECK(png.width == picture.width());
  CHECK(png.height == picture.height());
  CHECK(png.channels == (picture.has_opacity() ? 4 : 3));
  CHECK(png.chunks == "IHDR sRGB IDAT IEND ");
  CHECK(png.bytes == srgb_bytes(picture));
  CHECK(png_bytes(picture) == bytes);
}

/// The same numbers on every machine.
struct noise {
  std::uint32_t state = 1;
  float operator()() { return static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0f; }
};

}  // namespace

TEST_CASE("png_bytes: a decoder finds the bytes of the picture") {
  check_png(image(1, 1, {1, 0, 0}));
  check_png(image(1, 300));
  check_png(image(300, 1, {0.5f, 0.25f, 1}));
  image picture = gradient(70, 50);
  check_png(picture);
  picture(69, 49) = {7, -1, std::numeric_limits<float>::quiet_NaN()};
  check_png(picture);
}

TEST_CASE("png_bytes: noise, which fills more than one block, and strings of every distance") {
  noise next;
  image picture(200, 120);
  for (std::size_t y = 0; y < 120; ++y)
    for (std::size_t x = 0; x < 200; ++x) picture(x, y) = {next(), next(), next()};
  check_png(picture);
  CHECK(png_bytes(picture).size() < 200 * 120 * 3 * 1.01);
  for (std::size_t y = 60; y < 120; ++y)
    for (std::size_t x = 0; x < 200; ++x) picture(x, y) = picture(x, y - 50);
  check_png(picture);
  CHECK(png_bytes(picture).size() < 200 * 120 * 3 * 0.56);  // the 60 rows of 120 that are not repeated, within the window of deflate
}

TEST_CASE("png_bytes: words of code lengths beyond the limit are shortened") {
  image picture(1, 1);
  std::vector<float> shades;  // as often as the Fibonacci numbers: without a limit, code words of up to 22 bits
  std::size_t a = 1, b = 1;
  for (int k = 0; k < 22; ++k) {
    shades.insert(shades.end(), a, linear_from_srgb(static_cast<float>(7 * k) / 255));
    b += a;
    a = b - a;
  }
  picture = image(shades.size() / 3, 1);
  noise next;
  for (std::size_t i = shades.size(); i-- > 1;) std::swap(shades[i], shades[static_cast<std::size_t>(next() * static_cast<float>(i))]);
  for (std::size_t i = 0; i + 2 < shades.size(); i += 3) picture(i / 3, 0) = {shades[i], shades[i + 1], shades[i + 2]};
  check_png(picture);
}

TEST_CASE("png_bytes: an area of one colour takes few bytes") { CHECK(png_bytes(image(640, 480, {1, 1, 1})).size() < 2500); }

TEST_CASE("png_bytes: opacities are a fourth channel") {
  image picture = gradient(9, 4);
  CHECK(!picture.has_opacity());
  CHECK(std::as_const(picture).opacity(3, 2) == 1);
  picture.add_opacity(0.5f);
  picture.opacity(8, 3) = 0;
  picture.opacity(7, 3) = 2;
  picture.opacity(6, 3) = std::numeric_limits<float>::quiet_NaN();
  check_png(picture);
  const auto png = read_png(png_bytes(picture));
  CHECK(png.bytes[3] == 128);
  CHECK(png.bytes[png.bytes.size() - 1] == 0);
  CHECK(png.bytes[png.bytes.size() - 5] == 255);
  CHECK(png.bytes[png.bytes.size() - 9] == 0);
}

TEST_CASE("save_png: the file has the same bytes; one that is there is replaced") {
  const testing::temporary_folder dir;
  const image picture = gradient(7, 5);
  const std::string path = dir / "a.png";
  testing::write_file(path, "old");
  save_png(picture, path);
  const std::string text = testing::read_file(path);
  const auto bytes = png_bytes(picture);
  CHECK(std::equal(text.begin(), text.end(), bytes.begin(), bytes.end(),
                   [](char c, std::uint8_t b) { return static_cast<std::uint8_t>(c) == b; }));
  CHECK(dir.num_files() == 1);
}

TEST_CASE("save_png: errors leave no file behind") {
  const testing::temporary_folder dir;
  CHECK_THROWS_AS(save_png(image(2, 2), dir / "no/such/folder.png"), io_error);
  CHECK_THROWS_WITH_AS(save_png(image(), dir / "empty.png"), doctest::Contains("empty.png: the picture has no pixels"), invalid_argument);
  CHECK_THROWS_WITH_AS(png_bytes(image()), "png_bytes: the picture has no pixels", invalid_argument);
  CHECK_THROWS_AS(save_png(image(2, 2), std::string("a\0.png", 6)), io_error);
  CHECK(dir.num_files() == 0);
  std::filesystem::create_directory(dir / "folder.png");
  CHECK_THROWS_AS(save_png(image(2, 2), dir / "folder.png"), io_error);
  CHECK(dir.num_files() == 1);
}

TEST_CASE("save_png: a symbolic link is kept, and the file it refers to is written") {
  const testing::temporary_folder dir;
  std::filesystem::create_symlink("real.png", dir / "link.png");
  save_png(image(2, 2), dir / "link.png", {.sync = true});
  CHECK(std::filesystem::is_symlink(dir / "link.png"));
  CHECK(std::filesystem::is_regular_file(std::filesystem::symlink_status(dir / "real.png")));
}

TEST_CASE("image: sRGB bytes survive the way to linear light and back") {
  for (int i = 0; i < 256; ++i) {
    const float x = static_cast<float>(i) / 255;
    CHECK(srgb_bytes(srgb(x, x, x))[1] == i);
  }
  CHECK_THROWS_AS(image(0, 3), invalid_argument);
  CHECK_THROWS_AS(image(3, 65536), invalid_argument);
  CHECK(lightness({1, 1, 1}) == doctest::Approx(100));
  CHECK(lightness({0, 0, 0}) == 0);
}
