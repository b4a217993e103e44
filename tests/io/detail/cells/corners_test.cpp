#include <concino/io/detail/cells/corners.hpp>

#include <doctest/doctest.h>

#include <vector>

using namespace concino;
using namespace concino::detail;

TEST_CASE("first_repeated: finds the first repeated vert of a short or long list") {
  std::vector<vert_id> v;
  std::vector<std::uint64_t> scratch;
  for (unsigned i = 0; i < 100; ++i) v.push_back(vert_id{i});
  for (const std::size_t n : {5u, 32u, 33u, 100u}) CHECK(first_repeated(v.data(), n, scratch) == n);
  v[20] = vert_id{3};
  v[70] = vert_id{60};
  CHECK(first_repeated(v.data(), 25, scratch) == 20);
  CHECK(first_repeated(v.data(), 100, scratch) == 20);
  CHECK(first_repeated(v.data() + 21, 79, scratch) == 49);
}

TEST_CASE("first_repeated: works for lists of any length, with any indices") {
  for (const std::uint32_t n : {33u, 64u, 65u, 128u, 200u, 1000u})
    for (const std::uint32_t step : {1u, 2u, 64u, 65536u, 0x9e3779b1u}) {
      std::vector<vert_id> v;
      std::vector<std::uint64_t> scratch;
      for (std::uint32_t i = 0; i < n; ++i) v.push_back(vert_id{i * step});
      CHECK(first_repeated(v.data(), n, scratch) == n);
      v.push_back(v[n / 2]);
      CHECK(first_repeated(v.data(), n + 1, scratch) == n);
    }
}

TEST_CASE("first_repeated: finds equal consecutive verts") {
  std::vector<vert_id> v;
  std::vector<std::uint64_t> scratch;
  for (unsigned i = 0; i < 100; ++i) v.push_back(vert_id{i});
  v[1] = v[0];
  CHECK(first_repeated(v.data(), 5, scratch) == 1);
  CHECK(first_repeated(v.data(), 100, scratch) == 1);
}
