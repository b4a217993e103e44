#include <concino/mesh/detail/pair_numbers.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

using concino::detail::pair_numbers;

namespace {

/// Numbers the pairs, and compares with a map that is asked for one after another.
void are_numbered_as_they_come(pair_numbers& numbers, const std::vector<std::uint32_t>& first, const std::vector<std::uint32_t>& second, std::uint32_t first_bound,
                               std::uint32_t second_bound) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
  std::vector<std::uint32_t> expected, first_indices, found = first;
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    const auto [at, is_new] = known.try_emplace({first[i], second[i]}, static_cast<std::uint32_t>(known.size()));
    if (is_new) first_indices.push_back(i);
    expected.push_back(at->second);
  }
  numbers.number(found.data(), second.data(), found.size(), first_bound, second_bound);
  CHECK(found == expected);
  CHECK(numbers.size() == known.size());
  CHECK(std::vector<std::uint32_t>(numbers.begin(), numbers.end()) == first_indices);
}

}  // namespace

TEST_CASE("pair_numbers: pairs have the numbers in which they come") {
  pair_numbers numbers;
  std::vector<std::uint32_t> first = {3, 0, 3, 3, 0};
  const std::vector<std::uint32_t> second = {1, 1, 0, 1, 3};
  numbers.number(first.data(), second.data(), 5, 4, 4);
  CHECK(first == std::vector<std::uint32_t>{0, 1, 2, 0, 3});
  CHECK(std::vector<std::uint32_t>(numbers.begin(), numbers.end()) == std::vector<std::uint32_t>{0, 1, 2, 4});
}

TEST_CASE("pair_numbers: no pairs, equal pairs, different pairs and random ones, in the same memory") {
  std::mt19937 random(5);
  pair_numbers numbers;
  are_numbered_as_they_come(numbers, {}, {}, 0, 0);
  for (const std::uint32_t first_bound : {1u, 2u, 30u, 4000u, 7u})
    for (const std::uint32_t second_bound : {1u, 50u, 3000u}) {
      std::vector<std::uint32_t> first, second;
      for (unsigned i = 0; i < 3000; ++i) {
        first.push_back(static_cast<std::uint32_t>(random() % first_bound));
        second.push_back(second_bound == 3000 ? i : static_cast<std::uint32_t>(random() % second_bound));
      }
      are_numbered_as_they_come(numbers, first, second, first_bound, second_bound);
    }
}
