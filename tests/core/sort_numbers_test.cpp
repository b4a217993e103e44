#include <concino/core/sort_numbers.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace concino;

TEST_CASE("sort_numbers: sorts none, few and many numbers of both types") {
  std::mt19937_64 random(7);
  for (const std::size_t n : {0u, 1u, 2u, 15u, 16u, 17u, 1000u, 2048u, 5000u}) {
    std::vector<std::uint64_t> large(n + 1);
    std::vector<int> small(n + 1);
    for (std::uint64_t& x : large) x = random();
    for (int& x : small) x = static_cast<int>(random() % 100) - 50;
    const std::uint64_t last_large = large.back();
    const int last_small = small.back();
    core::sort_numbers(large.data(), large.data() + n);
    core::sort_numbers(small.data(), small.data() + n);
    CHECK(std::is_sorted(large.begin(), large.end() - 1));
    CHECK(std::is_sorted(small.begin(), small.end() - 1));
    CHECK(large.back() == last_large);
    for (std::uint64_t& x : large) x = random() % 300 << 30;
    std::vector<std::uint64_t> sorted = large;
    std::sort(sorted.begin(), sorted.end());
    core::sort_numbers(large.data(), large.data() + large.size());
    CHECK(large == sorted);
    CHECK(small.back() == last_small);
  }
}
