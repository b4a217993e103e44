#include <concino/solve/detail/sparse_sums.hpp>

#include <doctest/doctest.h>

#include <cstddef>
#include <random>
#include <vector>

TEST_CASE("sparse_sums: adds up by index, and forgets all when cleared") {
  std::mt19937 random(3);
  concino::detail::sparse_sums sums(50);
  for (const int terms : {0, 1, 7, 300}) {
    std::vector<double> expected(50);
    sums.expect(terms);
    for (int k = 0; k < terms; ++k) {
      const auto i = random() % 50;
      sums.add(static_cast<int>(i), k);
      expected[i] += k;
    }
    double all = 0;
    for (int k = 0; k < sums.size(); ++k) {
      CHECK(sums.sum(k) == expected[static_cast<std::size_t>(sums.index(k))]);
      all += sums.sum(k);
    }
    CHECK(all == terms * (terms - 1) / 2);
    CHECK(sums.size() <= 50);
    sums.clear();
    CHECK(sums.size() == 0);
  }
}
