#include <concino/core/prefetch.hpp>

#include <doctest/doctest.h>

#include <vector>

using namespace concino;

TEST_CASE("prefetch: rows that are stored in memory have an address, others have none") {
  struct stored {
    const int* first;
    const void* row() const { return first; }
  };
  const int values[] = {1, 2, 3};
  CHECK(core::row_address(id_span<int>(values, values + 3)) == values);
  CHECK(core::row_address(stored{values + 1}) == values + 1);
  static_assert(core::is_contiguous<id_span<int>> && core::is_contiguous<stored>);
  static_assert(!core::is_contiguous<std::vector<int>>);
  core::prefetch(values);
  core::prefetch(nullptr);
  core::prefetch(0, 0);  // no mesh
}

TEST_CASE("prefetch: rows of any kind can be requested, empty ones too") {
  const int values[] = {1, 2, 3};
  const id_span<int> all(values, values + 3), none;
  core::prefetch_row(all), core::prefetch_row(none);
  core::prefetch_rows(all, none, std::vector<int>{1});
  CHECK(all.size() == 3);
}
