// The adapter ignores stb settings of the program: with this one it would not compile.
#define STBIW_FREE(p) own p
#include <concino/adapters/stb.hpp>
#if !defined(STBIW_FREE) || defined(STBIW_MALLOC)
#error "the adapter changed a program's settings of stb"
#endif
#undef STBIW_FREE

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

#include <doctest/doctest.h>

#include <filesystem>

using namespace concino;

namespace {

struct scratch_folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / "concino_stb_test";
  scratch_folder() { std::filesystem::create_directories(path); }
  ~scratch_folder() { std::filesystem::remove_all(path); }
};

}  // namespace

TEST_CASE("a PNG file has the bytes of the picture") {
  const scratch_folder scratch;
  const std::string file = (scratch.path / "a.png").string();
  image picture(7, 5);
  for (std::size_t y = 0; y < 5; ++y)
    for (std::size_t x = 0; x < 7; ++x) picture(x, y) = srgb(static_cast<float>(x) / 6, static_cast<float>(y) / 4, 0.5f);
  picture(6, 4) = {7, -1, std::numeric_limits<float>::quiet_NaN()};
  write_png(picture, file);
  write_png(picture, file);  // over an existing file
  int width = 0, height = 0, channels = 0;
  unsigned char* bytes = stbi_load(file.c_str(), &width, &height, &channels, 0);
  REQUIRE(bytes);
  CHECK(width == 7);
  CHECK(height == 5);
  CHECK(channels == 3);
  const auto expected = srgb_bytes(picture);
  CHECK(std::equal(expected.begin(), expected.end(), bytes));
  stbi_image_free(bytes);
  CHECK(std::distance(std::filesystem::directory_iterator(scratch.path), {}) == 1);  // no temporary file is left
}

TEST_CASE("a failing write of a picture is an error, and leaves no file behind") {
  const scratch_folder scratch;
  CHECK_THROWS_AS(write_png(image(2, 2), (scratch.path / "no" / "such" / "folder.png").string()), io_error);
  CHECK_THROWS_AS(write_png(image(), (scratch.path / "empty.png").string()), invalid_argument);
  std::filesystem::create_directory(scratch.path / "folder.png");
  CHECK_THROWS_AS(write_png(image(2, 2), (scratch.path / "folder.png").string()), io_error);
  CHECK(std::distance(std::filesystem::directory_iterator(scratch.path), {}) == 1);
}

TEST_CASE("pictures use atomic_file: links, long names and invalid paths are handled alike") {
  const scratch_folder scratch;
  namespace fs = std::filesystem;
  fs::create_symlink("real.png", scratch.path / "link.png");
  write_png(image(2, 2), (scratch.path / "link.png").string(), {.sync = true});
  CHECK(fs::is_symlink(scratch.path / "link.png"));
  CHECK(fs::is_regular_file(fs::symlink_status(scratch.path / "real.png")));
  write_png(image(2, 2), (scratch.path / (std::string(251, 'n') + ".png")).string());
  CHECK_THROWS_AS(write_png(image(2, 2), (scratch.path / "a").string() + std::string("\0.png", 5)), io_error);
  CHECK(std::distance(fs::directory_iterator(scratch.path), {}) == 3);
}

TEST_CASE("reading a PNG file gives the same sRGB bytes") {
  for (int i = 0; i < 256; ++i) {
    const float x = static_cast<float>(i) / 255;
    CHECK(srgb_bytes(srgb(x, x, x))[1] == i);
  }
  CHECK_THROWS_AS(image(0, 3), invalid_argument);
  CHECK_THROWS_AS(image(3, 65536), invalid_argument);
  CHECK(lightness({1, 1, 1}) == doctest::Approx(100));
  CHECK(lightness({0, 0, 0}) == 0);
}
