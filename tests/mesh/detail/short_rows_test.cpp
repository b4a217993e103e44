// Searches and gaps in rows of at most eight values, compared with the algorithms of the standard library.
#include <concino/mesh/detail/short_rows.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>

TEST_CASE("short_rows: the first of equal values is found") {
  std::mt19937 random(3);
  for (int round = 0; round < 500; ++round) {
    std::array<unsigned, 8> row;
    for (unsigned& x : row) x = static_cast<unsigned>(random() % 5);
    for (unsigned value = 0; value < 6; ++value) {
      const auto at = std::find(row.begin(), row.end(), value);
      CHECK(concino::detail::find_in_eight(row.data(), value) == at - row.begin());
    }
  }
}

TEST_CASE("short_rows: closing a gap keeps the order, and what is behind the row") {
  for (unsigned n = 1; n <= 8; ++n)
    for (unsigned k = 0; k < n; ++k) {
      std::array<int, 10> row{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, expected = row;
      std::copy(expected.begin() + k + 1, expected.begin() + n, expected.begin() + k);
      concino::detail::close_gap_in_eight(row.data(), k, n);
      CHECK(row == expected);
    }
}
