#include <concino/core/block_allocator.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

using namespace concino::core;

template<class T>
using array = std::vector<T, block_allocator<T>>;

TEST_CASE("block_allocator: arrays have their values, whether the block has room or not, and whether it is small or large") {
  for (const std::size_t bytes : {0u, 100u, 10000u, 2000000u}) {
    const auto block = std::make_shared<memory_block>(bytes);
    std::vector<array<std::uint64_t>> all;
    for (std::size_t n = 0; n < 200; ++n) {
      array<char> small(n % 7, 'a', block_allocator<char>(block));
      array<std::uint64_t> a(n, 0, block_allocator<std::uint64_t>(block));
      REQUIRE(reinterpret_cast<std::uintptr_t>(a.data()) % alignof(std::uint64_t) == 0);
      std::iota(a.begin(), a.end(), n);
      all.push_back(std::move(a));
    }
    bool same = true;
    for (std::size_t n = 0; n < 200; ++n)
      for (std::size_t i = 0; i < n; ++i) same = same && all[n][i] == n + i;
    CHECK(same);
  }
}

TEST_CASE("block_allocator: the block lives as long as an array in it; copies have memory of their own") {
  auto block = std::make_shared<memory_block>(std::size_t{1000});
  const std::weak_ptr<memory_block> watched = block;
  array<int> copy;
  {
    array<int> a({1, 2, 3}, block_allocator<int>(std::move(block)));
    CHECK(watched.lock()->contains(a.data()));
    array<int> moved = std::move(a);
    a = {};
    CHECK(watched.lock()->contains(moved.data()));
    copy = moved;
    const array<int> second = moved;
    CHECK(second.get_allocator() == block_allocator<int>());
    CHECK_FALSE(watched.lock()->contains(second.data()));
  }
  CHECK(watched.expired());
  CHECK(copy == array<int>{1, 2, 3});
}
