// Counts the bytes that this program holds on the heap: include in exactly one source file of a program.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace bench::heap {

inline std::size_t live = 0, peak = 0;

inline void* take(std::size_t n, std::size_t alignment) {
  void* p = nullptr;
  if (alignment > alignof(std::max_align_t)) p = std::aligned_alloc(alignment, (n + alignment - 1) / alignment * alignment);
  else p = std::malloc(n ? n : 1);
  if (!p) throw std::bad_alloc();
  live += malloc_usable_size(p);
  if (live > peak) peak = live;
  return p;
}

inline void give(void* p) {
  if (!p) return;
  live -= malloc_usable_size(p);
  std::free(p);
}

}  // namespace bench::heap

void* operator new(std::size_t n) { return bench::heap::take(n, 0); }
void* operator new[](std::size_t n) { return bench::heap::take(n, 0); }
void* operator new(std::size_t n, std::align_val_t a) { return bench::heap::take(n, static_cast<std::size_t>(a)); }
void* operator new[](std::size_t n, std::align_val_t a) { return bench::heap::take(n, static_cast<std::size_t>(a)); }
void operator delete(void* p) noexcept { bench::heap::give(p); }
void operator delete[](void* p) noexcept { bench::heap::give(p); }
void operator delete(void* p, std::size_t) noexcept { bench::heap::give(p); }
void operator delete[](void* p, std::size_t) noexcept { bench::heap::give(p); }
void operator delete(void* p, std::align_val_t) noexcept { bench::heap::give(p); }
void operator delete[](void* p, std::align_val_t) noexcept { bench::heap::give(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { bench::heap::give(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { bench::heap::give(p); }
