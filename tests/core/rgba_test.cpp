#include <concino/core/rgba.hpp>

#include <doctest/doctest.h>

using namespace concino;

TEST_CASE("rgba: is opaque white by default") {
  CHECK(rgba{} == rgba{1, 1, 1, 1});
  CHECK(rgba{1, 0, 0} == rgba{1, 0, 0, 1});
  CHECK(rgba{1, 0, 0} != rgba{1, 0, 0, 0.5f});
}

TEST_CASE("rgba: bytes from 0 to 255 become components from 0 to 1") {
  CHECK(rgba_of_bytes(255, 0, 51) == rgba{1, 0, 0.2f, 1});
  CHECK(rgba_of_bytes(0, 0, 0, 0) == rgba{0, 0, 0, 0});
}
