#include <concino/graph/disjoint_sets.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

using namespace concino;

TEST_CASE("disjoint_sets: the root is the smallest index, in any order of unions") {
  disjoint_sets sets(6);
  CHECK(sets.num_sets() == 6);
  CHECK(sets.unite(4, 2));
  CHECK(sets.unite(5, 3));
  CHECK(sets.unite(3, 4));
  CHECK_FALSE(sets.unite(2, 5));
  for (const std::size_t i : {2u, 3u, 4u, 5u}) CHECK(sets.root(i) == 2);
  CHECK(sets.num_sets() == 3);
  CHECK(sets.are_united(3, 5));
  CHECK_FALSE(sets.are_united(0, 5));
  CHECK(sets.unite_roots(0, 2) == 0);
  CHECK(sets.unite_roots(1, 0) == 0);
  for (std::size_t i = 0; i < 6; ++i) CHECK(sets.root(i) == 0);
  CHECK(sets.num_sets() == 1);
}

TEST_CASE("disjoint_sets: may be empty, grow one by one, and be reused") {
  disjoint_sets sets;
  CHECK(sets.size() == 0);
  CHECK(sets.num_sets() == 0);
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < 4; ++i) CHECK(sets.add() == i);
    CHECK(sets.size() == 4);
    CHECK(sets.num_sets() == 4);
    CHECK(sets.unite(3, 1));
    CHECK(sets.root(3) == 1);
    CHECK(sets.root(2) == 2);
    sets.clear();
    CHECK(sets.size() == 0);
  }
}

TEST_CASE("disjoint_sets: 1,000 random unions agree with naive labels") {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    const std::size_t n = 1 + random() % 100;
    disjoint_sets sets(n);
    std::vector<std::size_t> label(n);
    std::size_t count = n;
    for (std::size_t i = 0; i < n; ++i) label[i] = i;
    for (int k = 0; k < 50; ++k) {
      const std::size_t a = random() % n, b = random() % n, low = std::min(label[a], label[b]), high = std::max(label[a], label[b]);
      REQUIRE(sets.are_united(a, b) == (low == high));
      REQUIRE(sets.unite(a, b) == (low != high));
      count -= low != high;
      for (std::size_t& l : label)
        if (l == high) l = low;
      for (std::size_t i = 0; i < n; ++i) REQUIRE(sets.root(i) == label[i]);
      REQUIRE(sets.num_sets() == count);
    }
  }
}

TEST_CASE("disjoint_sets: more indices than 32 bits throw") {
  if constexpr (sizeof(std::size_t) > 4)
    CHECK_THROWS_WITH_AS(disjoint_sets(std::size_t{1} << 32), "disjoint_sets: there are 2^32 indices or more; 32 bits cannot number them", invalid_argument);
}
