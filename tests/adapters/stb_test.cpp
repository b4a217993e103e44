// The adapter ignores stb settings of the program: with these it would not compile.
#define STBI_FREE(p) own p
#define STBI_NO_PNG
#include <concino/adapters/stb.hpp>
#if !defined(STBI_FREE) || !defined(STBI_NO_PNG) || defined(STBI_MALLOC)
#error "the adapter changed a program's settings of stb"
#endif
#undef STBI_FREE
#undef STBI_NO_PNG

// The program may contain its own copy of stb beside that of the adapter.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include <concino/render/png.hpp>

#include <doctest/doctest.h>
#include <support/temporary.hpp>

using namespace concino;
using concino::testing::temporary_folder;
using concino::testing::write_file;

namespace {

image gradient(bool has_opacity = false) {
  image picture(17, 9);
  if (has_opacity) picture.add_opacity();
  for (std::size_t y = 0; y < 9; ++y)
    for (std::size_t x = 0; x < 17; ++x) {
      picture(x, y) = srgb(static_cast<float>(x) / 16, static_cast<float>(y) / 8, 0.5f);
      if (has_opacity) picture.opacity(x, y) = static_cast<float>(x + y) / 24;
    }
  return picture;
}

/// The bytes of a file that stb_image_write makes of a picture.
template<class F>
std::string written(F&& write) {
  std::string bytes;
  write([](void* to, void* data, int size) { static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size)); }, &bytes);
  return bytes;
}

std::string png_file(const image& picture) {
  const auto bytes = png_bytes(picture);
  return {bytes.begin(), bytes.end()};
}
std::string jpg_file(const image& picture) {
  const auto pixels = srgb_bytes(picture);
  return written([&](auto f, void* to) { stbi_write_jpg_to_func(f, to, static_cast<int>(picture.width()), static_cast<int>(picture.height()), 3, pixels.data(), 95); });
}
std::string bmp_file(const image& picture) {
  const auto pixels = srgb_bytes(picture);
  return written([&](auto f, void* to) { stbi_write_bmp_to_func(f, to, static_cast<int>(picture.width()), static_cast<int>(picture.height()), 3, pixels.data()); });
}
std::string tga_file(const image& picture) {
  const auto pixels = srgb_bytes(picture);
  return written([&](auto f, void* to) {
    stbi_write_tga_to_func(f, to, static_cast<int>(picture.width()), static_cast<int>(picture.height()), picture.has_opacity() ? 4 : 3, pixels.data());
  });
}

}  // namespace

TEST_CASE("read_image: reads what save_png writes, with opacities, and BMP and TGA files, to the byte") {
  const temporary_folder dir;
  for (const bool has_opacity : {false, true}) {
    const image picture = gradient(has_opacity);
    save_png(picture, dir / "a.png");
    CHECK(read_image(dir / "a.png").has_opacity() == has_opacity);
    CHECK(srgb_bytes(read_image(dir / "a.png")) == srgb_bytes(picture));
    write_file(dir / "a.tga", tga_file(picture));
    CHECK(srgb_bytes(read_image(dir / "a.tga")) == srgb_bytes(picture));
  }
  write_file(dir / "named.png", bmp_file(gradient()));  // the content decides
  CHECK(srgb_bytes(read_image(dir / "named.png")) == srgb_bytes(gradient()));
}

TEST_CASE("read_image: a JPEG file has nearly the colours that were written") {
  const temporary_folder dir;
  write_file(dir / "a.jpg", jpg_file(gradient()));
  const image seen = read_image(dir / "a.jpg");
  REQUIRE(seen.width() == 17);
  REQUIRE(seen.height() == 9);
  const auto a = srgb_bytes(seen), b = srgb_bytes(gradient());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(std::abs(int{a[i]} - int{b[i]}) < 24);
}

TEST_CASE("read_image: missing, empty, foreign and huge files are errors that name the file") {
  const temporary_folder dir;
  CHECK_THROWS_AS(read_image(dir / "missing.png"), io_error);
  CHECK_THROWS_AS(read_image(dir.path()), io_error);
  write_file(dir / "empty.png", "");
  CHECK_THROWS_WITH_AS(read_image(dir / "empty.png"), doctest::Contains("empty.png"), parse_error);
  write_file(dir / "text.png", "v 0 0 0\n");
  CHECK_THROWS_WITH_AS(read_image(dir / "text.png"), doctest::Contains("text.png:1: expected a PNG, JPEG, BMP or TGA file, found 'unknown image type'"), parse_error);
  std::string huge = bmp_file(image(1, 1));
  for (const std::size_t at : {std::size_t{18}, std::size_t{22}}) huge[at] = '\0', huge[at + 1] = '\x40';  // 16,384 x 16,384 pixels
  write_file(dir / "huge.bmp", huge);
  CHECK_THROWS_WITH_AS(read_image(dir / "huge.bmp"), doctest::Contains("16384 x 16384 pixels are more than 2^27"), unsupported);
}

TEST_CASE("fuzz: picture files that end early or have a wrong byte are pictures or errors") {
  const temporary_folder dir;
  const std::string path = dir / "a";
  std::size_t refused = 0;
  const auto read = [&](const std::string& bytes) {
    write_file(path, bytes);
    try {
      const image picture = read_image(path);
      CHECK(picture.width() > 0);
    } catch (const error&) {
      ++refused;
    }
  };
  image small(5, 4);
  small(2, 2) = {1, 0.5f, 0};
  for (const std::string& file : {png_file(small), jpg_file(small), bmp_file(small), tga_file(small)}) {
    for (std::size_t n = 0; n < file.size(); n += 1 + n / 24) read(file.substr(0, n));
    for (std::size_t i = 0; i < file.size(); i += 1 + i / 32)
      for (const char c : {'\0', '\x7f', '\xff'}) {
        std::string damaged = file;
        damaged[i] = c;
        read(damaged);
      }
  }
  CHECK(refused > 50);
  const std::string png = png_file(gradient());
  for (std::size_t n = 0; n + 12 < png.size(); n += 19) {
    write_file(path, png.substr(0, n));
    CHECK_THROWS_AS(read_image(path), parse_error);
  }
}
