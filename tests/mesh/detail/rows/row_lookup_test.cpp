// row_lookup finds values in rows, short and long, also after the rows have changed.
#include <concino/mesh/detail/rows/row_lookup.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace concino;
using concino::detail::row_lookup;
using concino::detail::jagged_array;

TEST_CASE("row_lookup: finds the position of every value in its row, also after changes") {
  std::mt19937 random(5);
  jagged_array<vert_id, 0> all;
  std::vector<std::vector<vert_id>> lists;
  for (const unsigned n : {0u, 1u, 64u, 65u, 3u, 200u, 66u}) {
    std::vector<vert_id> list;
    for (unsigned i = 0; i < n; ++i) list.push_back(vert_id{3 * i + 1});
    std::shuffle(list.begin(), list.end(), random);
    all.add_row(list.begin(), list.end());
    lists.push_back(list);
  }
  const row_lookup places(all);
  const auto are_right = [&] {
    for (std::uint32_t r = 0; r < lists.size(); ++r) {
      for (std::uint32_t k = 0; k < lists[r].size(); ++k) CHECK(places.find(r, all[r], lists[r][k]) == k);
      for (const unsigned absent : {0u, 3u, 9999u}) CHECK(places.find(r, all[r], vert_id{absent}) == lists[r].size());
    }
  };
  are_right();
  // Values added after the construction are found by linear search.
  lists.push_back(lists[5]);
  std::reverse(lists.back().begin(), lists.back().end());
  all.add_row(lists.back().begin(), lists.back().end());
  all.push(3, vert_id{50000});
  lists[3].push_back(vert_id{50000});
  all.remove(5, lists[5][10]);
  lists[5].erase(lists[5].begin() + 10);
  all.push(5, vert_id{60000});
  lists[5].push_back(vert_id{60000});
  are_right();
}
