#include <concino/level_sets/detail/announced_numbers.hpp>

#include <doctest/doctest.h>

#include <cstddef>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <vector>

using concino::core::memory_block;
using concino::detail::announced_numbers;

namespace {

void check_numbers(announced_numbers numbers, std::size_t bound) {
  std::mt19937 random(5);
  std::vector<std::size_t> announced{0, 63, 64, 127, bound - 1};
  for (unsigned i = 0; i < 200; ++i) announced.push_back(random() % bound);
  for (const std::size_t i : announced) numbers.announce(i);
  numbers.announce(announced[0]);
  std::map<std::size_t, std::size_t> expected;
  CHECK(numbers.count() == std::set<std::size_t>(announced.begin(), announced.end()).size());
  for (unsigned round = 0; round < 1000; ++round) {
    const std::size_t i = announced[random() % announced.size()];
    const std::size_t next = expected.size(), number = expected.emplace(i, next).first->second;
    CHECK(numbers.add(i, next) == number);
  }
}

}  // namespace

TEST_CASE("announced_numbers: indices have numbers in the order in which they come") {
  constexpr std::size_t bound = 1000;
  check_numbers(announced_numbers(bound), bound);
}

TEST_CASE("announced_numbers: they lie in a block, and on the heap if it has no room") {
  constexpr std::size_t bound = 1000;
  const auto block = std::make_shared<memory_block>(announced_numbers::bytes_for(bound, 205));
  check_numbers(announced_numbers(bound, block), bound);
  CHECK(!block->has_room(announced_numbers::bytes_for(bound, 0)));
  check_numbers(announced_numbers(bound, block), bound);
  check_numbers(announced_numbers(bound, std::make_shared<memory_block>(64)), bound);
}
