// If an allocation fails while a picture is read, std::bad_alloc is thrown, and nothing leaks.
#include <concino/adapters/stb.hpp>

#include <concino/render/png.hpp>

#include <support/failing_allocations.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

using namespace concino;

TEST_CASE("reading a picture without memory throws, and the next attempt gives the picture") {
  const testing::temporary_folder dir;
  image picture(9, 6, rgb{1, 1, 1});
  for (std::size_t i = 0; i < 6; ++i) picture(i, i) = rgb{0, 0.5f, 1};
  save_png(picture, dir / "a.png");
  const auto expected = srgb_bytes(picture);
  const auto result = testing::for_each_failing_allocation([&](const auto& attempt) {
    image seen;
    const bool failed = attempt([&] { seen = read_image(dir / "a.png"); });
    CHECK((failed ? seen.width() == 0 : srgb_bytes(seen) == expected));
  });
  CHECK(result.failed > 5);
  CHECK(result.leaks == 0);
}
