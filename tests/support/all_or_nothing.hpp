// Runs an edit of a mesh with each of its allocations failing. Only in programs that can use support/failing_allocations.hpp.
#pragma once

#include <concino/validate/check_laws.hpp>

#include <support/failing_allocations.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <vector>

namespace concino::testing {

/// Runs edit(m) with each of its allocations failing, and checks that m is unchanged and can be edited afterwards. sparsity: see
/// for_each_failing_allocation.
template<class M, class F>
std::size_t all_or_nothing(const M& before, const F& edit, std::size_t sparsity = 0) {
  const std::vector<double> old = whole(before);
  M edited = before;
  edit(edited);
  const std::vector<double> expected = whole(edited);
  bool looked = false;
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    M m = before;
    if (attempt([&] { edit(m); })) {
      CHECK(whole(m) == old);
      edit(m);
      if (!looked) CHECK(check_laws(m).empty());
      looked = true;
    }
    CHECK(whole(m) == expected);
  }, sparsity);
  CHECK(result.leaks == 0);
  return result.failed;
}

}  // namespace concino::testing
