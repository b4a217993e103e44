#include <concino/core/indexed_heap.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <random>
#include <vector>

using concino::core::indexed_heap;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("indexed_heap: finds the smallest of random keys that decrease, as a linear search does") {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    const std::size_t n = 1 + random() % 40;
    std::vector<double> keys(n, inf), expected(n, inf);
    std::vector<unsigned char> waits(n);
    indexed_heap<int> heap(keys);
    for (int step = 0; step < 200; ++step) {
      const std::size_t i = random() % n;
      const double key = static_cast<double>(random() % 1000000);
      if (random() % 3 > 0) {
        if (expected[i] < inf && !waits[i]) continue;  // was removed before
        if (!(key < heap.key(i))) continue;
        heap.decrease_key(static_cast<int>(i), i, key);
        expected[i] = key;
        waits[i] = 1;
      } else if (!heap.empty()) {
        double least = inf;
        for (std::size_t k = 0; k < n; ++k)
          if (waits[k] && expected[k] < least) least = expected[k];
        REQUIRE(heap.min_key() == least);
        REQUIRE(waits[static_cast<std::size_t>(heap.front())]);
        const auto [node, slot, popped] = heap.pop();
        REQUIRE(static_cast<std::size_t>(node) == slot);
        REQUIRE(popped == least);
        REQUIRE(expected[slot] == least);
        waits[slot] = 0;
      }
      bool any = false;
      for (const unsigned char w : waits) any = any || w;
      REQUIRE(heap.empty() == !any);
    }
    REQUIRE(keys == expected);
    std::size_t waiting = 0, forgotten = 0;
    for (const unsigned char w : waits) waiting += w;
    heap.discard_waiting([&](int node) {
      REQUIRE(waits[static_cast<std::size_t>(node)]);
      ++forgotten;
    });
    CHECK(forgotten == waiting);
    CHECK(heap.empty());
    for (std::size_t k = 0; k < n; ++k) REQUIRE(keys[k] == (waits[k] ? inf : expected[k]));
  }
}
