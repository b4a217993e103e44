// flat_array does not initialise its values, and otherwise behaves like std::vector.
#include <concino/core/flat_array.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <random>

using concino::core::flat_array;

namespace {

std::vector<int> values(const flat_array<int>& a) { return {a.begin(), a.end()}; }

}  // namespace

TEST_CASE("flat_array: random operations agree with std::vector") {
  std::mt19937 random(1);
  flat_array<int> a;
  std::vector<int> oracle;
  for (int step = 0; step < 2000; ++step) {
    switch (random() % 6) {
      case 0: {
        const std::vector<int> more(random() % 40, step);
        a.append(more.data(), more.size());
        oracle.insert(oracle.end(), more.begin(), more.end());
        break;
      }
      case 1:
        a.shrink_to_fit();
        break;
      case 2:
        if (!oracle.empty()) {
          a.push_back(a[0]);  // the argument is in the array, which may be reallocated
          a.append(a.data(), 1);
          oracle.insert(oracle.end(), 2, oracle[0]);
        }
        break;
      case 3: {
        const std::size_t n = random() % (oracle.size() + 1);
        if (random() % 20 == 0) {
          a.resize(n);
          oracle.resize(n);
        }
        break;
      }
      default:
        a.push_back(step);
        oracle.push_back(step);
    }
    REQUIRE(a.size() == oracle.size());
  }
  CHECK(values(a) == oracle);
}

TEST_CASE("flat_array: a moved vector is not copied until it has to grow") {
  std::vector<int> given{1, 2, 3};
  const int* const where = given.data();
  flat_array<int> a(std::move(given));
  CHECK(a.data() == where);
  flat_array<int> moved(std::move(a));
  CHECK(moved.data() == where);
  CHECK(a.size() == 0);
  moved.push_back(4);
  CHECK(values(moved) == std::vector<int>{1, 2, 3, 4});
}

TEST_CASE("flat_array: copies are independent") {
  flat_array<int> a(3, 7);
  flat_array<int> b = a;
  b[1] = 8;
  CHECK(values(a) == std::vector<int>{7, 7, 7});
  CHECK(values(b) == std::vector<int>{7, 8, 7});
  a = b;
  CHECK(values(a) == std::vector<int>{7, 8, 7});
  const flat_array<int> given(std::vector<int>{5});
  CHECK(values(flat_array<int>(given)) == std::vector<int>{5});
}

TEST_CASE("flat_array: empty arrays work") {
  flat_array<int> a(std::vector<int>{});
  CHECK(a.size() == 0);
  a.shrink_to_fit();
  flat_array<int> b = a;
  b.append(b.data(), 0);
  CHECK(b.size() == 0);
  b.push_back(1);
  CHECK(b[0] == 1);
}

TEST_CASE("flat_array: sizes beyond the address space throw") { CHECK_THROWS_AS(flat_array<int>(static_cast<std::size_t>(-1) / 4), std::bad_alloc); }

TEST_CASE("flat_array: a request for pages keeps the values, and the room behind them") {
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{5000}, std::size_t{300'000}, std::size_t{3'000'000}}) {
    flat_array<unsigned> a(n, 7u, n + n / 8);
    CHECK(a.size() == n);
    CHECK(std::count(a.begin(), a.end(), 7u) == static_cast<std::ptrdiff_t>(n));
    const unsigned* const before = a.data();
    a.resize(n + n / 8);
    CHECK(a.data() == before);
  }
}

TEST_CASE("flat_array: large arrays keep their values when they shrink and grow") {
  flat_array<int> a(3 << 20, 5);
  a.resize(1 << 20);
  a.shrink_to_fit();
  a.push_back(6);
  CHECK(a[(1 << 20) - 1] == 5);
  CHECK(a[1 << 20] == 6);
}
