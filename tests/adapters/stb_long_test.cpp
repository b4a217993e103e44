// A picture with more bytes than an int of stb can count throws.
#include <concino/adapters/stb.hpp>

#include <support/corpus.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <unistd.h>

using namespace concino;

TEST_CASE("a picture of more than 1 GiB throws, and no file is created") {
  if (::sysconf(_SC_AVPHYS_PAGES) < 6 * (1l << 30) / ::sysconf(_SC_PAGESIZE)) return testing::skip("less than 6 GiB of memory are free");
  const testing::temporary_folder dir;
  CHECK_THROWS_WITH_AS(write_png(image(65535, 5462), dir / "a.png"), doctest::Contains("65535 x 5462 pixels are more than 1 GiB"), unsupported);
  CHECK(dir.num_files() == 0);
}
