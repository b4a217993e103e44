// Replaces malloc and its siblings by the linker options -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=aligned_alloc,--wrap=free.
// operator new of support/allocations.cpp calls them too. Calls inside shared libraries are not replaced.
#include "failing_allocations.hpp"

#include "allocations.hpp"

#include <atomic>

extern "C" {
void* __real_malloc(std::size_t);
void* __real_calloc(std::size_t, std::size_t);
void* __real_realloc(void*, std::size_t);
void* __real_aligned_alloc(std::size_t, std::size_t);
void __real_free(void*);
}

namespace {

std::atomic<std::size_t> asked{0}, failing{0};  // failing: 0 for none
std::atomic<bool> later{false};
std::atomic<std::ptrdiff_t> blocks{0};

bool fails() {
  const std::size_t n = failing.load(std::memory_order_relaxed);
  if (n == 0) return false;
  const std::size_t i = ++asked;
  return i == n || (i > n && later);
}
void* counted(void* p) {
  if (p) ++blocks;
  return p;
}

}  // namespace

namespace concino::testing::detail {

void begin_failing(std::size_t n, bool all_later) {
  allocated_so_far();  // a program without allocations.cpp does not link: its operator new would never fail
  asked = 0;
  later = all_later;
  failing = n;
}
std::size_t end_failing() noexcept {
  failing = 0;
  return asked;
}
std::ptrdiff_t blocks_in_use() noexcept { return blocks; }

}  // namespace concino::testing::detail

extern "C" {
void* __wrap_malloc(std::size_t size) { return fails() ? nullptr : counted(__real_malloc(size)); }
void* __wrap_calloc(std::size_t n, std::size_t size) { return fails() ? nullptr : counted(__real_calloc(n, size)); }
void* __wrap_realloc(void* p, std::size_t size) {
  if (fails()) return nullptr;
  void* const moved = __real_realloc(p, size);
  if (moved && !p) ++blocks;
  return moved;
}
void* __wrap_aligned_alloc(std::size_t align, std::size_t size) { return fails() ? nullptr : counted(__real_aligned_alloc(align, size)); }
void __wrap_free(void* p) {
  if (p) --blocks;
  __real_free(p);
}
}
