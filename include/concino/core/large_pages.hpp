// Large pages for large arrays. The first access to some ten thousand small pages takes the system a third of the time in which a mesh
// is built.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace concino::core {

/// Arrays of fewer bytes remain on small pages.
inline constexpr std::size_t min_bytes_on_large_pages = std::size_t{1} << 22;

/// Requests large pages for memory that will be written. This is only advice: no result depends on it, and smaller arrays are ignored.
inline void prefer_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  constexpr std::uintptr_t page = std::uintptr_t{1} << 21;
  if (bytes < min_bytes_on_large_pages) return;
  const std::uintptr_t first = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) & ~(page - 1);
  const std::uintptr_t last = (reinterpret_cast<std::uintptr_t>(memory) + bytes) & ~(page - 1);
  ::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
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
