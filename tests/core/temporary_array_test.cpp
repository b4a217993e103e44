#include <concino/core/temporary_array.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <new>
#include <utility>

using namespace concino::core;

TEST_CASE("temporary_array: arrays have their values, whatever their size") {
  for (const std::size_t n : {0u, 1u, 1000u, 170000u, 180000u, 524288u, 1500000u}) {
    const temporary_array<std::uint32_t> a(n, 7u);
    REQUIRE(a.capacity() >= n);
    bool all = true;
    for (std::size_t i = 0; i < n; ++i) all &= a[i] == 7;
    CHECK(all);
  }
}

TEST_CASE("temporary_array: all of its room can be written, and moves with it") {
  for (const std::size_t n : {3u, 700000u}) {
    temporary_array<std::uint64_t> a(n), b;
    for (std::size_t i = 0; i < a.capacity(); ++i) a[i] = i;
    const std::uint64_t* const data = a.data();
    b = std::move(a);
    CHECK(b.data() == data);
    CHECK(a.capacity() == 0);
    bool all = true;
    for (std::size_t i = 0; i < b.capacity(); ++i) all &= b[i] == i;
    CHECK(all);
  }
}

TEST_CASE("temporary_array: a size that no memory has is bad_alloc") {
  const auto allocate = [](std::size_t n) { return temporary_array<std::uint64_t>(n).capacity(); };
  constexpr std::size_t huge = std::numeric_limits<std::size_t>::max();
  CHECK_THROWS_AS(allocate(huge), std::bad_alloc);
  CHECK_THROWS_AS(allocate(huge / 8), std::bad_alloc);
  CHECK_THROWS_AS(allocate(huge / 32), std::bad_alloc);
}
