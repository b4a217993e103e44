#include <concino/core/local_numbers.hpp>

#include <doctest/doctest.h>

#include <vector>

namespace core = concino::core;

TEST_CASE("local_numbers: keys have the numbers in which they come") {
  core::local_numbers numbers;
  CHECK(numbers.find(7) == core::local_numbers::none);
  CHECK(numbers.add(7) == 0);
  CHECK(numbers.add(0) == 1);
  CHECK(numbers.add(7) == 0);
  CHECK(numbers.find(0) == 1);
  CHECK(numbers.size() == 2);
  CHECK(numbers[0] == 7);
}

TEST_CASE("local_numbers: many keys, equal in their low or high bits") {
  for (const std::size_t factor : {std::size_t{1}, std::size_t{1} << 12, std::size_t{1} << 40}) {
    core::local_numbers numbers;
    for (std::size_t i = 0; i < 3000; ++i) REQUIRE(numbers.add(i * factor) == i);
    for (std::size_t i = 0; i < 3000; ++i) REQUIRE(numbers.find(i * factor) == i);
    CHECK(numbers.find(3000 * factor) == core::local_numbers::none);
    CHECK(std::vector<std::size_t>(numbers.begin(), numbers.end()).back() == 2999 * factor);
  }
}
