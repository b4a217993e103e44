// If an allocation fails while a picture is compressed or written, the file is the old one or the complete new one, and nothing leaks.
#include <concino/render/png.hpp>

#include <support/failing_allocations.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

using namespace concino;
using concino::testing::read_file;

TEST_CASE("saving a picture without memory keeps the old file or replaces it") {
  image picture(9, 6, rgb{1, 1, 1});
  for (std::size_t i = 0; i < 6; ++i) picture(i, i) = rgb{0, 0.5f, 1};
  const testing::temporary_folder dir;
  const std::string path = dir / "a.png";
  save_png(picture, path);
  const std::string expected = read_file(path);
  const auto result = testing::for_each_failing_allocation([&](const auto& attempt) {
    testing::write_file(path, "old");
    const bool failed = attempt([&] { save_png(picture, path); });
    CHECK(read_file(path) == (failed ? "old" : expected));
    CHECK(dir.num_files() == 1);
  });
  CHECK(result.failed > 10);
  CHECK(result.leaks == 0);
}
