#include <concino/level_sets/detail/announced_numbers.hpp>

#include <doctest/doctest.h>

#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <vector>

TEST_CASE("announced_numbers: indices have numbers in the order in which they come") {
  constexpr std::size_t bound = 1000;
  std::mt19937 random(5);
  concino::detail::announced_numbers numbers(bound);
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
