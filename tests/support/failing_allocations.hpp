// Runs code with a failing n-th allocation, for every n. Only in programs that link support/allocations.cpp and
// support/failing_allocations.cpp with the linker options named there.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <new>

namespace concino::testing {

namespace detail {

/// Makes the n-th allocation from now on fail (n = 1: the next one) and, with `all_later`, every one after it. Counts those of all threads.
void begin_failing(std::size_t n, bool all_later);
/// Stops failing. Returns the number of allocations since begin_failing().
std::size_t end_failing() noexcept;
/// The number of blocks of memory that are allocated and not freed.
std::ptrdiff_t blocks_in_use() noexcept;

struct failing_scope {
  failing_scope(std::size_t n, bool all_later) { begin_failing(n, all_later); }
  failing_scope(const failing_scope&) = delete;
  failing_scope& operator=(const failing_scope&) = delete;
  ~failing_scope() { end_failing(); }
};

}  // namespace detail

/// One attempt: `attempt(g)` runs g() with a failing allocation and returns whether it threw std::bad_alloc. Other exceptions are passed on.
class failing_attempt {
  std::size_t n_, asked_ = 0;
  bool all_later_;

 public:
  failing_attempt(std::size_t n, bool all_later) : n_(n), all_later_(all_later) {}
  std::size_t asked() const { return asked_; }

  template<class G>
  bool operator()(G&& g) {
    bool failed = false;
    {
      const detail::failing_scope scope(n_, all_later_);
      try {
        g();
      } catch (const std::bad_alloc&) {
        failed = true;
      }
      asked_ = detail::end_failing();
    }
    return failed;
  }
};

struct allocation_failures {
  std::size_t allocations = 0;  ///< of the code when none fails
  std::size_t failed = 0;       ///< attempts that threw std::bad_alloc
  std::size_t leaks = 0;        ///< attempts after which memory was still in use
};

/// Calls f(attempt) for n = 1, 2, ... with a failing n-th allocation, until attempt(g) needs fewer than n. It does so twice for each n: only that
/// allocation fails, or all later ones too. Allocations of f outside of attempt(g) do not fail: there it prepares g and checks the state afterwards.
/// With a `sparsity` s > 0, the number grows by n / s from one attempt to the next.
template<class F>
allocation_failures for_each_failing_allocation(F&& f, std::size_t sparsity = 0) {
  allocation_failures result;
  for (std::size_t n = 1;; n += 1 + (sparsity ? n / sparsity : 0)) {
    for (const bool all_later : {false, true}) {
      const std::ptrdiff_t before = detail::blocks_in_use();
      failing_attempt attempt(n, all_later);
      bool failed = false;
      f([&](auto&& g) { return failed = attempt(g); });
      if (detail::blocks_in_use() != before) ++result.leaks;
      result.failed += failed;
      if (attempt.asked() < n) {
        result.allocations = n - 1;
        return result;
      }
    }
  }
}

}  // namespace concino::testing
