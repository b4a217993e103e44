// Counts the bytes that this program holds on the heap. It replaces malloc of the GNU C library, so that operator new, realloc and linked libraries count too.
// Include it in exactly one source file of a program.
#pragma once

#include <cerrno>
#include <cstddef>

#include <malloc.h>
#if __has_include(<mm_malloc.h>)
#include <mm_malloc.h>  // declares posix_memalign without noexcept, which clang accepts only before the definition below
#endif

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
}

namespace bench::heap {

inline std::size_t live = 0, peak = 0, taken = 0;  // bytes now, maximum of bytes, number of allocations

inline void* count(void* p) {
  ++taken;
  if (!p) return p;
  live += malloc_usable_size(p);
  if (live > peak) peak = live;
  return p;
}
inline std::size_t size_of(void* p) { return p ? malloc_usable_size(p) : 0; }

}  // namespace bench::heap

extern "C" {
void* malloc(std::size_t n) noexcept { return bench::heap::count(__libc_malloc(n)); }
void* calloc(std::size_t n, std::size_t size) noexcept { return bench::heap::count(__libc_calloc(n, size)); }
/// A block that the system maps grows by moving its pages. Any other block that moves is counted twice for a moment.
void* realloc(void* old, std::size_t n) noexcept {
  const std::size_t before = bench::heap::size_of(old);
  const bool mapped = old && (static_cast<const std::size_t*>(old)[-1] & 2);
  void* const p = __libc_realloc(old, n);
  if (!p && n) return p;
  const bool copied = !mapped && p != old;
  if (!copied) bench::heap::live -= before;
  bench::heap::count(p);
  if (copied) bench::heap::live -= before;
  return p;
}
void* memalign(std::size_t alignment, std::size_t n) noexcept { return bench::heap::count(__libc_memalign(alignment, n)); }
void* aligned_alloc(std::size_t alignment, std::size_t n) noexcept { return bench::heap::count(__libc_memalign(alignment, n)); }
int posix_memalign(void** p, std::size_t alignment, std::size_t n) noexcept {
  void* const got = bench::heap::count(__libc_memalign(alignment, n));
  if (!got) return ENOMEM;
  *p = got;
  return 0;
}
void free(void* p) noexcept {
  bench::heap::live -= bench::heap::size_of(p);
  __libc_free(p);
}
}
