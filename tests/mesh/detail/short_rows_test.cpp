// Searches and gaps in rows of at most eight values, compared with the algorithms of the standard library.
#include <concino/mesh/detail/short_rows.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

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

TEST_CASE("short_rows: each way to get the bits of comparisons is right") {
  for (unsigned bits = 0; bits < 256; ++bits) {
    concino::detail::eight_comparisons is_true;
    for (unsigned k = 0; k < 8; ++k) is_true[k] = (bits >> k & 1) != 0 ? -1 : 0;
    CHECK(concino::detail::bits_of_eight(is_true) == bits);
#ifdef __SSE__
    CHECK(concino::detail::bits_of_eight_by_signs(is_true) == bits);
#endif
  }
}

TEST_CASE("short_rows: rows of any length, with and without eight readable values") {
  std::mt19937 random(4);
  for (unsigned n = 0; n < 20; ++n)
    for (unsigned behind = 0; behind < 10; ++behind) {
      std::vector<unsigned> row(n + behind);
      for (unsigned& x : row) x = static_cast<unsigned>(random() % 12);
      for (unsigned value = 0; value < 13; ++value) {
        const auto at = static_cast<unsigned>(std::find(row.begin(), row.begin() + n, value) - row.begin());
        CHECK(concino::detail::find_in_short_row(row.data(), n, row.size(), value) == at);
        if (at < n) CHECK(concino::detail::position_in_row(row.data(), row.size(), value) == at);
      }
      for (unsigned k = 0; k < n; ++k) {
        std::vector<unsigned> now = row, expected = row;
        std::copy(expected.begin() + k + 1, expected.begin() + n, expected.begin() + k);
        concino::detail::close_gap_in_row(now.data(), k, n, now.size());
        now.erase(now.begin() + n - 1), expected.erase(expected.begin() + n - 1);  // what was the last value is any one now
        CHECK(now == expected);
      }
    }
}
