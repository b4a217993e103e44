// Large pages for large arrays. The first access to some ten thousand small pages takes the system a third of the time in which a mesh
// is built.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace concino::core {

/// Requests large pages for memory that will be written. This is only advice: no result depends on it, and arrays of less than
/// 4 MiB are ignored. The request is for all small pages that the memory is on, although large ones fit into the middle only: Linux moves memory of different
/// kinds by a copy, and realloc() would take longer.
inline void prefer_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  if (bytes < std::size_t{1} << 22) return;
  const auto page = static_cast<std::uintptr_t>(::getpagesize());
  const std::uintptr_t first = reinterpret_cast<std::uintptr_t>(memory) & ~(page - 1);
  const std::uintptr_t last = (reinterpret_cast<std::uintptr_t>(memory) + bytes + page - 1) & ~(page - 1);
  ::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
}

/// Whether realloc() would copy this memory to small pages when it becomes large. Memory that glibc has mapped begins 16 bytes behind a page and is moved
/// without a copy. No result depends on the answer.
inline bool is_copied_by_realloc([[maybe_unused]] const void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__GLIBC__)
  constexpr std::uintptr_t small_page = 4096;
  return memory && bytes >= std::size_t{1} << 22 && reinterpret_cast<std::uintptr_t>(memory) % small_page != 16;
#else
  return false;
#endif
}

/// Like v.reserve(n). Values that move to other memory are written there after the request.
template<class T>
void reserve_large(std::vector<T>& v, std::size_t n) {
  if (n <= v.capacity()) return;
  std::vector<T> larger;
  larger.reserve(n);
  prefer_large_pages(larger.data(), n * sizeof(T));
  larger.assign(v.begin(), v.end());
  v.swap(larger);
}

/// A vector of n equal values.
template<class T>
std::vector<T> large_vector(std::size_t n, const T& value) {
  std::vector<T> v;
  reserve_large(v, n);
  v.assign(n, value);
  return v;
}

}  // namespace concino::core
