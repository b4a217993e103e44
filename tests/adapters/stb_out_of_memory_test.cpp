// If an allocation fails while a picture is compressed or written, the file is the old one or the complete new one, and nothing leaks.
#include <concino/adapters/stb.hpp>

#include <support/failing_allocations.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <string>

using namespace concino;
using concino::testing::read_file;

namespace {

void written_or_not(const image& picture) {
  const testing::temporary_folder dir;
  const std::string path = dir / "a.png";
  write_png(picture, path);
  const std::string expected = read_file(path);
  const auto result = testing::for_each_failing_allocation([&](const auto& attempt) {
    testing::write_file(path, "old");
    const bool failed = attempt([&] { write_png(picture, path); });
    CHECK(read_file(path) == (failed ? "old" : expected));
    CHECK(dir.num_files() == 1);
  });
  CHECK(result.failed > 10);
  CHECK(result.leaks == 0);
}

}  // namespace

TEST_CASE("saving a picture of few colours without memory keeps the old file or replaces it") {
  image picture(9, 6, rgb{1, 1, 1});
  for (std::size_t i = 0; i < 6; ++i) picture(i, i) = rgb{0, 0.5f, 1};
  written_or_not(picture);
}

// The picture is stored without compression, which would make it larger.
TEST_CASE("saving a picture of noise without memory keeps the old file or replaces it") {
  image picture(8, 5);
  std::uint32_t state = 1;
  const auto next = [&] { return static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0f; };
  for (std::size_t y = 0; y < 5; ++y)
    for (std::size_t x = 0; x < 8; ++x) picture(x, y) = rgb{next(), next(), next()};
  written_or_not(picture);
}
