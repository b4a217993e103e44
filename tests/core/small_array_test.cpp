#include <concino/core/small_array.hpp>

#include <doctest/doctest.h>

#include <vector>

TEST_CASE("small_array: holds what a vector holds, below and above its own room") {
  for (const std::size_t n : {0u, 1u, 4u, 5u, 100u}) {
    concino::core::small_array<int, 4> a;
    std::vector<int> expected;
    for (std::size_t i = 0; i < n; ++i) a.push_back(static_cast<int>(i * i)), expected.push_back(static_cast<int>(i * i));
    CHECK(std::vector<int>(a.begin(), a.end()) == expected);
    CHECK(a.size() == n);
    CHECK(a.empty() == (n == 0));
    if (n > 0) CHECK(a.back() == expected.back());
  }
}

TEST_CASE("small_array: resize keeps the values and fills up") {
  concino::core::small_array<int, 2> a(1, 7);
  a.resize(5, 8);
  CHECK(std::vector<int>(a.begin(), a.end()) == std::vector<int>{7, 8, 8, 8, 8});
  a.resize(2, 9);
  CHECK(std::vector<int>(a.begin(), a.end()) == std::vector<int>{7, 8});
  a.clear();
  CHECK(a.empty());
}

TEST_CASE("small_array: a value of the array can be appended while the array moves") {
  concino::core::small_array<int, 2> a;
  a.push_back(3), a.push_back(4);
  a.push_back(a[0]);
  CHECK(a[2] == 3);
  a.resize(9, a[1]);
  CHECK(a[8] == 4);
}

TEST_CASE("small_array: no push_back moves the values after reserve") {
  concino::core::small_array<int, 2> a;
  a.reserve(10);
  const int* const at = a.data();
  for (int i = 0; i < 10; ++i) a.push_back(i);
  CHECK(a.data() == at);
}
