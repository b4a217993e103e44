#include <concino/core/large_pages.hpp>

#include <doctest/doctest.h>

#include <cstdlib>
#include <vector>

using namespace concino::core;

TEST_CASE("large_pages: whole_pages is at least the size, and adds at most what it may add") {
  for (const std::size_t bytes : {0u, 1u, 1000u, 1500000u, 2097119u, 2097120u, 2097121u, 2097152u, 4000000u, 50000000u})
    for (const std::size_t max_unused : {std::size_t{0}, bytes / 3, 2 * bytes}) {
      const std::size_t size = whole_pages(bytes, max_unused);
      CHECK(size >= bytes);
      CHECK(size - bytes <= max_unused);
    }
}

TEST_CASE("large_pages: vectors have their values, whatever their size") {
  for (const std::size_t n : {0u, 1u, 1000u, 300000u, 1500000u}) {
    CHECK(large_vector(n, 7) == std::vector<int>(n, 7));
    CHECK(exact_vector(n, 7) == std::vector<int>(n, 7));
    std::vector<int> v{1, 2, 3};
    reserve_large(v, n);
    CHECK(v.capacity() >= n);
    CHECK(v == std::vector<int>{1, 2, 3});
    std::vector<int> exact{1, 2, 3};
    reserve_exact(exact, n);
    CHECK(exact.capacity() >= n);
    CHECK(exact == std::vector<int>{1, 2, 3});
  }
}

TEST_CASE("large_pages: reallocate_large keeps what is used, whatever the sizes and wherever the memory was") {
  for (const std::size_t first : {1u, 1000u, 3000000u, 5000000u})
    for (const std::size_t then : {2000u, 2097120u, 2097152u, 9000000u}) {
      if (then < first) continue;
      auto* const before = static_cast<unsigned char*>(reallocate_large(nullptr, 0, first));
      REQUIRE(before);
      for (std::size_t i = 0; i < first; ++i) before[i] = static_cast<unsigned char>(i * 7);
      auto* const after = static_cast<unsigned char*>(reallocate_large(before, first, then));
      REQUIRE(after);
      std::size_t differ = 0;
      for (std::size_t i = 0; i < first; ++i) differ += after[i] != static_cast<unsigned char>(i * 7);
      CHECK(differ == 0);
      for (std::size_t i = first; i < then; ++i) after[i] = 1;
      std::free(after);
    }
}

TEST_CASE("large_pages: make_room keeps the values, and trim ends the growth") {
  std::vector<int> v;
  for (std::size_t n = 0; n < 100000; ++n) {
    make_room(v, n + 1);
    REQUIRE(v.size() > n);
    v[n] = static_cast<int>(n);
  }
  trim(v, 100000);
  REQUIRE(v.size() == 100000);
  bool all = true;
  for (std::size_t n = 0; n < v.size(); ++n) all &= v[n] == static_cast<int>(n);
  CHECK(all);
  trim(v, 10);
  CHECK(v == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  CHECK(v.capacity() <= 15);
}

TEST_CASE("large_pages: append_large keeps the values, and doubles the memory") {
  std::vector<int> v;
  std::size_t moves = 0;
  for (int n = 0; n < 1000000; ++n) {
    moves += v.size() == v.capacity();
    append_large(v, n);
  }
  CHECK(moves < 25);
  bool all = v.size() == 1000000;
  for (int n = 0; all && n < 1000000; ++n) all = v[static_cast<std::size_t>(n)] == n;
  CHECK(all);
}
