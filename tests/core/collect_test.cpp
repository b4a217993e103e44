#include <concino/core/collect.hpp>

#include <concino/edit/elements.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/kinds.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <cstddef>
#include <list>
#include <stdexcept>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE("collect_if: what is kept, in the order of the range, for any number of threads") {
  const auto m = grid<trimesh>(300);  // more verts than a few parts hold
  const std::list<int> numbers = [] {
    std::list<int> r;
    for (int i = 0; i < 50000; ++i) r.push_back(i * 7919 % 50021);
    return r;
  }();
  for (const int threads : {1, 2, 5}) {
    const with_num_threads fixed(threads);
    const auto keep = [](vert_id v) { return v.raw() % 7 == 3; };
    std::vector<vert_id> expected;
    for (const vert_id v : verts(m))
      if (keep(v)) expected.push_back(v);
    CHECK(core::collect_if(verts(m), keep) == expected);

    std::vector<int> odd;
    for (const int n : numbers)
      if (n % 2) odd.push_back(n);
    CHECK(core::collect_if(numbers, [](int n) { return n % 2 != 0; }) == odd);
  }
}

TEST_CASE("collect_if: leaves out elements that do not exist") {
  auto m = grid<trimesh>(200);
  for (const unsigned at : {0u, 5u, 63u, 64u, 65u, 640u, 16383u, 16384u, 16400u, 79'999u}) remove_poly(m, poly_id{at});
  for (unsigned at = 1024; at < 1200; ++at) remove_poly(m, poly_id{at});  // none of 64 is left
  for (const int threads : {1, 3}) {
    const with_num_threads fixed(threads);
    for (const unsigned step : {1u, 2u, 7u, 64u, 129u, 5000u, 100000u}) {
      const auto keep = [step](poly_id p) { return p.raw() % step == 3 % step; };
      std::vector<poly_id> expected;
      for (const poly_id p : polys(m))
        if (keep(p)) expected.push_back(p);
      CHECK(core::collect_if(polys(m), keep) == expected);
    }
  }
}

TEST_CASE("collect_if: nothing of nothing, and everything") {
  const std::vector<int> none, some{3, 1, 2};
  const auto all = [](int) { return true; };
  CHECK(core::collect_if(none, all).empty());
  CHECK(core::collect_if(some, all) == some);
  CHECK(core::collect_if(some, [](int) { return false; }).empty());
  const trimesh empty;
  CHECK(core::collect_if(verts(empty), [](vert_id) { return true; }).empty());
}

TEST_CASE("collect_if: exceptions of the condition reach the caller") {
  const std::vector<int> numbers(30000, 1);
  for (const int threads : {1, 3}) {
    const with_num_threads fixed(threads);
    CHECK_THROWS_AS((void)core::collect_if(numbers, [](int) -> bool { throw std::runtime_error("no"); }), std::runtime_error);
  }
}
