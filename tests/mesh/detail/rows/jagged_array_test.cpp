// jagged_array: rows that are packed, of equal length, and edited.
#include <concino/mesh/detail/rows/jagged_array.hpp>

#include <doctest/doctest.h>

#include <random>
#include <vector>

using concino::detail::make_jagged_array;
using concino::detail::jagged_array;

namespace {

std::vector<int> row(const jagged_array<int, 0>& r, std::size_t i) { return {r.begin(i), r.end(i)}; }

jagged_array<int, 0> three_rows() {
  jagged_array<int, 0> r = make_jagged_array<int>({0, 2, 0, 3});
  int next = 0;
  for (int* at = r.begin(0); at != r.begin(0) + 5; ++at) *at = next++;
  return r;
}

}  // namespace

TEST_CASE("jagged_array: packed rows are at their offsets") {
  const jagged_array<int, 0> r = three_rows();
  CHECK(r.size() == 3);
  CHECK(row(r, 0) == std::vector<int>{0, 1});
  CHECK(row(r, 1).empty());
  CHECK(row(r, 2) == std::vector<int>{2, 3, 4});
}

TEST_CASE("jagged_array: rows of equal length need no offsets until one is edited") {
  jagged_array<int, 0> a = three_rows(), b(a.shared_offsets(), std::vector<int>(5, 7));
  CHECK(a.shared_offsets() == b.shared_offsets());
  b.push(0, 8);
  CHECK(a.shared_offsets() != b.shared_offsets());
  CHECK(row(a, 0) == std::vector<int>{0, 1});
  CHECK(row(b, 0) == std::vector<int>{7, 7, 8});
  CHECK(row(b, 2) == std::vector<int>{7, 7, 7});
}

TEST_CASE("jagged_array: copies are independent, moved-from arrays are empty") {
  jagged_array<int, 0> a = three_rows();
  a.push(1, 9);
  jagged_array<int, 0> b = a;
  b.push(1, 10);
  CHECK(row(a, 1) == std::vector<int>{9});
  CHECK(row(b, 1) == std::vector<int>{9, 10});
  const jagged_array<int, 0> c = std::move(b);
  CHECK(row(c, 1) == std::vector<int>{9, 10});
  CHECK(b.size() == 0);
  a = c;
  CHECK(row(a, 1) == std::vector<int>{9, 10});
}

TEST_CASE("jagged_array: rows have room to grow after make_growable()") {
  jagged_array<int, 0> r = three_rows();
  r.make_growable();
  CHECK(row(r, 0) == std::vector<int>{0, 1});
  CHECK(row(r, 1).empty());
  CHECK(row(r, 2) == std::vector<int>{2, 3, 4});
  const std::size_t values = r.num_values();
  for (std::size_t i = 0; i < 3; ++i) r.push(i, 7), r.push(i, 8);
  CHECK(r.num_values() == values);
  CHECK(row(r, 1) == std::vector<int>{7, 8});
  CHECK(row(r, 2) == std::vector<int>{2, 3, 4, 7, 8});
  CHECK(r.find_in_row(2, 8) == 4);
  CHECK(r.find_in_row(2, 1) == 5);
}

TEST_CASE("jagged_array: random edits agree with vectors of vectors") {
  std::mt19937 random(1);
  jagged_array<int, 0> r = three_rows();
  SUBCASE("where the rows were") {}
  SUBCASE("growable") { r.make_growable(); }
  std::vector<std::vector<int>> oracle{{0, 1}, {}, {2, 3, 4}};
  for (int step = 0; step < 3000; ++step) {
    const std::size_t i = random() % oracle.size();
    switch (random() % 8) {
      case 0: {
        const std::vector<int> fresh(random() % 4, step);
        r.add_row(fresh.begin(), fresh.end());
        oracle.push_back(fresh);
        break;
      }
      case 1:
        r.clear_row(i);
        oracle[i].clear();
        break;
      case 2:
      case 3:
        if (!oracle[i].empty()) {
          const int value = oracle[i][random() % oracle[i].size()];
          CHECK(r.find_in_row(i, value) == std::find(oracle[i].begin(), oracle[i].end(), value) - oracle[i].begin());
          r.remove(i, value);
          oracle[i].erase(std::find(oracle[i].begin(), oracle[i].end(), value));
        }
        break;
      default:
        r.push(i, step);
        oracle[i].push_back(step);
    }
  }
  REQUIRE(r.size() == oracle.size());
  for (std::size_t i = 0; i < oracle.size(); ++i) CHECK(row(r, i) == oracle[i]);
}

TEST_CASE("jagged_array: holds as many values as 32 bits can count") {
  concino::detail::offsets most{0, 0xFFFFFFFEu, 1}, more{0, 0xFFFFFFFFu, 1};
  CHECK_NOTHROW(concino::detail::prefix_sum(most));
  CHECK(most == concino::detail::offsets{0, 0xFFFFFFFEu, 0xFFFFFFFFu});
  CHECK_THROWS_AS(concino::detail::prefix_sum(more), concino::unsupported);
}

TEST_CASE("jagged_array: can be built by adding rows") {
  jagged_array<int, 0> r;
  const std::vector<int> one{1, 2}, two{3};
  r.add_row(one.begin(), one.end());
  const jagged_array<int, 0> copy = r;
  r.add_row(two.begin(), two.end());
  r.push(0, 4);
  CHECK(row(r, 0) == std::vector<int>{1, 2, 4});
  CHECK(row(r, 1) == two);
  CHECK(row(copy, 0) == one);
}

TEST_CASE("jagged_array: rows of equal length are right") {
  jagged_array<int, 2> r(std::vector<int>{1, 2, 3, 4});
  const int more[] = {5, 6};
  r.add_row(more, more + 2);
  CHECK(r.size() == 3);
  CHECK(r[2][1] == 6);
  CHECK(r.length(0) == 2);
}

TEST_CASE("jagged_array: a staged row is visible after commit, and may copy from the array") {
  jagged_array<int, 0> r = three_rows();
  const std::vector<int> before = row(r, 2);
  for (int i = 0; i < 20; ++i) {
    const int* const staged = r.stage_row(r.begin(2), 3);  // it is not committed, so the next one replaces it
    CHECK(std::vector<int>(staged, staged + 3) == before);
  }
  CHECK(r.size() == 3);
  r.stage_row(r.begin(2), 3, 5);
  r.commit_row(3, 5);
  CHECK(r.size() == 4);
  CHECK(row(r, 3) == before);
  const int* const at = r.begin(3);
  r.push(3, 7), r.push(3, 8);
  CHECK(r.begin(3) == at);
  r.push(3, 9);
  CHECK(row(r, 3) == std::vector<int>{2, 3, 4, 7, 8, 9});
  CHECK(row(r, 2) == before);
  int* const to_write = r.stage_row(nullptr, 2);
  to_write[0] = 5, to_write[1] = 6;
  r.commit_row(2);
  CHECK(row(r, 4) == std::vector<int>{5, 6});

  jagged_array<int, 2> pairs(std::vector<int>{1, 2, 3, 4});
  for (int i = 0; i < 20; ++i) {
    pairs.stage_row(pairs.begin(1), 2);
    CHECK(pairs.size() == 2u + static_cast<unsigned>(i));
    pairs.commit_row(2);
  }
  CHECK(pairs[21][0] == 3);
  CHECK(pairs[21][1] == 4);
}

TEST_CASE("jagged_array: with reserved capacity rows do not move when values are added") {
  jagged_array<int, 0> r = three_rows();
  r.reserve_in_row(1, 9);
  r.reserve_rows(2, 6);
  const int* const second = r.begin(1);
  const int* const third = r.begin(2);
  for (int i = 0; i < 9; ++i) r.push(1, i);
  const std::vector<int> values{1, 2, 3};
  r.add_row(values.begin(), values.end());
  r.add_row(values.begin(), values.end());
  CHECK(r.begin(1) == second);
  CHECK(r.begin(2) == third);
  CHECK(r.length(1) == 9);
  CHECK(row(r, 4) == values);
}
