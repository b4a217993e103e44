// The concept of element ranges, and the two range types of the library.
#include <concino/concepts/descriptors.hpp>
#include <concino/concepts/ranges.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace cn = concino;

static_assert(!cn::ElementRange<std::array<unsigned, 2>, cn::vert_id> && !cn::ElementRange<std::array<cn::poly_id, 2>, cn::vert_id>);
static_assert(cn::ElementRange<std::array<cn::vert_id, 2>, cn::vert_id> && cn::ElementRange<const std::vector<cn::vert_id>&, cn::vert_id>);
static_assert(cn::ElementRange<cn::id_span<cn::vert_id>, cn::vert_id> && cn::ElementRange<cn::id_range<cn::vert_id>, cn::vert_id>);
static_assert(!cn::ElementRange<cn::vert_id, cn::vert_id> && !cn::ElementRange<int, int>);

TEST_CASE("id_range skips deleted elements, and both ranges can be iterated repeatedly") {
  const unsigned char dead[] = {1, 0, 1, 1, 0, 1};
  const cn::id_range<cn::poly_id> r(6, dead);
  for (int walk = 0; walk < 2; ++walk) {
    std::vector<unsigned> met;
    for (auto p : r) met.push_back(p.raw());
    CHECK(met == std::vector<unsigned>{1, 4});
  }
  const unsigned char all_dead[] = {1, 1};
  const cn::id_range<cn::poly_id> none(2, all_dead);
  CHECK_FALSE(none.begin() != none.end());
}

TEST_CASE("the parts of an id_range cover the range in order") {
  const unsigned char dead[] = {1, 0, 1, 1, 0, 1, 0};
  for (const unsigned char* const flags : {dead, static_cast<const unsigned char*>(nullptr)}) {
    const cn::id_range<cn::poly_id> r(7, flags);
    CHECK(r.index_bound() == 7);
    for (std::size_t size = 1; size <= 7; ++size) {
      std::vector<cn::poly_id> whole, parts;
      for (auto p : r) whole.push_back(p);
      for (std::size_t first = 0; first < 7; first += size)
        for (auto p : r.part(first, std::min<std::size_t>(7, first + size))) parts.push_back(p);
      CHECK(parts == whole);
    }
  }
}

TEST_CASE("id_span refers to memory that it does not own") {
  const std::vector<cn::vert_id> ids{cn::vert_id{4}, cn::vert_id{2}};
  const cn::id_span<cn::vert_id> r(ids.data(), ids.data() + ids.size());
  CHECK(r.size() == 2);
  CHECK(r[1] == cn::vert_id{2});
  CHECK(*r.begin() == cn::vert_id{4});
  CHECK(cn::id_span<cn::vert_id>().empty());
}

TEST_CASE("ids_where filters by a user's predicate") {
  const std::vector<bool> deleted{true, false, true, false, false, true};
  const auto r = cn::ids_where<cn::edge_id>(deleted.size(), [&](unsigned i) { return !deleted[i]; });
  static_assert(cn::ElementRange<decltype(r), cn::edge_id> && std::forward_iterator<decltype(r.begin())>);
  for (int walk = 0; walk < 2; ++walk) {
    std::vector<unsigned> met;
    for (auto e : r) met.push_back(e.raw());
    CHECK(met == std::vector<unsigned>{1, 3, 4});
  }
  const auto copy = [&] { return r; }();
  CHECK(*copy.begin() == cn::edge_id{1});
  const auto none = cn::ids_where<cn::vert_id>(3, [](unsigned) { return false; });
  CHECK_FALSE(none.begin() != none.end());
  const auto empty = cn::ids_where<cn::vert_id>(0, [](unsigned) { return true; });
  CHECK_FALSE(empty.begin() != empty.end());
}

template<class R> concept is_counted = requires(const R& r) { cn::num_elements(r); };
static_assert(is_counted<std::vector<int>> && !is_counted<int>);

TEST_CASE("num_elements counts the elements of any range, also arrays") {
  const unsigned char dead[] = {1, 0, 1, 1, 0, 1};
  CHECK(cn::num_elements(cn::id_range<cn::poly_id>(6, dead)) == 2);
  const std::vector<cn::vert_id> ids{cn::vert_id{4}, cn::vert_id{2}, cn::vert_id{2}};
  CHECK(cn::num_elements(ids) == 3);
  CHECK(cn::num_elements(cn::id_span<cn::vert_id>(ids.data(), ids.data() + 2)) == 2);
  CHECK(cn::num_elements(std::array<cn::vert_id, 2>{}) == 2);
  CHECK(cn::num_elements(cn::id_span<cn::vert_id>()) == 0);
  CHECK(cn::num_elements(cn::ids_where<cn::vert_id>(5, [](unsigned i) { return i % 2 == 0; })) == 3);
}
