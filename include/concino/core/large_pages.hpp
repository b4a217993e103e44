// Large pages for large arrays. The first access to some ten thousand small pages takes the system a third of the time in which a mesh
// is built.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <type_traits>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace concino::detail {

inline constexpr std::uintptr_t small_page = std::uintptr_t{1} << 12, large_page = std::uintptr_t{1} << 21;
inline constexpr std::size_t malloc_header = 32;  // at most so many bytes of glibc lie before memory that it has mapped

/// Makes the small pages at this address, where a large one begins, one large page. Returns false if the system refuses.
inline bool collapse_pages([[maybe_unused]] std::uintptr_t begin) {
#if defined(__linux__)
  constexpr int collapse = 25;  // MADV_COLLAPSE, Linux 6.1; glibc names it since 2.37
  return ::madvise(reinterpret_cast<void*>(begin), large_page, collapse) == 0;
#else
  return false;
#endif
}

}  // namespace concino::detail

namespace concino::core {

/// Requests pages for memory that will be written at once, which takes the system less time than the first access to each page. This is only advice.
inline void request_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(MADV_POPULATE_WRITE)
  constexpr std::uintptr_t page = detail::small_page;
  if (bytes < 4 * page) return;
  const std::uintptr_t first = reinterpret_cast<std::uintptr_t>(memory) & ~(page - 1);
  const std::uintptr_t last = (reinterpret_cast<std::uintptr_t>(memory) + bytes + page - 1) & ~(page - 1);
  ::madvise(reinterpret_cast<void*>(first), last - first, MADV_POPULATE_WRITE);
#endif
}

/// Requests large pages for memory that will be written. This is only advice: no result depends on it, and arrays of less than
/// a large page, 2 MiB, are ignored. The request is for all small pages that the memory is on, although large ones fit into the middle only: Linux moves memory
/// of different kinds by a copy, and realloc() would take longer.
inline void prefer_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  constexpr std::uintptr_t large_page = detail::large_page;
  if (bytes + detail::malloc_header < large_page) return;
  const auto page = static_cast<std::uintptr_t>(::getpagesize());
  const std::uintptr_t first = reinterpret_cast<std::uintptr_t>(memory) & ~(page - 1);
  const std::uintptr_t last = (reinterpret_cast<std::uintptr_t>(memory) + bytes + page - 1) & ~(page - 1);
  ::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
  // At both ends, memory that is in use, such as the header of malloc, keeps the rest of its large page small, unless the system makes a large one of
  // all now. It refuses where the memory of the program ends inside; then small pages are requested at once.
  for (const std::uintptr_t x : {first, last - 1}) {
    if (x == last - 1 && last % large_page == 0) continue;  // nothing is behind the memory, which may be room that stays unused
    const std::uintptr_t begin = x & ~(large_page - 1), end = begin + large_page;
    if (detail::collapse_pages(begin)) continue;
    const std::uintptr_t from = begin < first ? first : begin, to = end < last ? end : last;
    request_pages(reinterpret_cast<void*>(from), to - from);
  }
#endif
}

/// A size of at least `bytes` that fills large pages together with the header of malloc, so that the system aligns the memory. It is `bytes` if more than
/// `max_unused` bytes would be added.
inline std::size_t whole_pages(std::size_t bytes, std::size_t max_unused) {
#if defined(__linux__)
  constexpr std::size_t page = detail::large_page, header = detail::malloc_header;
  const std::size_t whole = ((bytes + header + page - 1) & ~(page - 1)) - header;
  if (whole - bytes <= max_unused) return whole;
#endif
  return bytes;
}

}  // namespace concino::core

namespace concino::detail {

/// Whether large pages fit into this memory from its beginning on: glibc has mapped it, 16 bytes behind the beginning of one.
inline bool is_on_large_pages(const void* memory) { return reinterpret_cast<std::uintptr_t>(memory) % large_page == 16; }

/// Memory of more than a large page from the beginning of one on: Linux aligns what is requested in whole large pages, and leaves it where it is when the rest is
/// returned.
inline void* reallocate_on_large_pages(void* memory, std::size_t bytes) {
  const std::size_t whole = bytes >= large_page ? core::whole_pages(bytes, large_page) : bytes;
  void* const larger = std::realloc(memory, whole);
  if (!larger || whole == bytes) return larger;
  void* const exact = std::realloc(larger, bytes);
  return exact ? exact : larger;
}

}  // namespace concino::detail

namespace concino::core {

/// Makes memory larger as realloc() does, and copies `used` bytes. If the system can use large pages only for memory at another place, it is copied there: glibc
/// moves memory that it has mapped without a copy, but then its pages remain as they were. No result depends on this.
inline void* reallocate_large(void* memory, std::size_t used, std::size_t bytes) {
#if defined(__GLIBC__)
  if (memory && bytes >= detail::large_page && !detail::is_on_large_pages(memory)) {
    void* const other = detail::reallocate_on_large_pages(nullptr, bytes);
    if (other && (detail::is_on_large_pages(other) || reinterpret_cast<std::uintptr_t>(memory) % detail::small_page != 16)) {
      prefer_large_pages(other, bytes);
      if (used > 0) std::memcpy(other, memory, used);
      std::free(memory);
      return other;
    }
    std::free(other);
  }
#endif
  void* const larger = detail::reallocate_on_large_pages(memory, bytes);
  if (!larger) return nullptr;
  prefer_large_pages(larger, bytes);
  // Where the memory ended before, the rest of a large page would be taken in small pages.
  const std::uintptr_t end = reinterpret_cast<std::uintptr_t>(larger) + used, begin = end & ~(detail::large_page - 1);
  if (used >= detail::large_page && end != begin && begin + detail::large_page <= reinterpret_cast<std::uintptr_t>(larger) + bytes) detail::collapse_pages(begin);
  return larger;
}

/// Reserves memory for n elements, and at most a third more, in large pages if these can be filled. Values that move to other memory are written there after
/// the request.
template<class T>
void reserve_large(std::vector<T>& v, std::size_t n) {
  if (n <= v.capacity()) return;
  const std::size_t bytes = whole_pages(n * sizeof(T), n * sizeof(T) / 3);
  std::vector<T> larger;
  larger.reserve(bytes / sizeof(T));
  prefer_large_pages(larger.data(), bytes);
  larger.assign(v.begin(), v.end());
  v.swap(larger);
}

/// Reserves memory for exactly n elements, for arrays that are kept.
template<class T>
void reserve_exact(std::vector<T>& v, std::size_t n) {
  if (n <= v.capacity()) return;
  std::vector<T> larger;
  larger.reserve(n);
  prefer_large_pages(larger.data(), n * sizeof(T));
  larger.assign(v.begin(), v.end());
  v.swap(larger);
}

/// Reserves memory for n elements that will be written at once.
template<class T>
void reserve_pages(std::vector<T>& v, std::size_t n) {
  if (n <= v.capacity()) return;
  reserve_large(v, n);
  request_pages(v.data() + v.size(), (n - v.size()) * sizeof(T));
}

/// Appends to a vector of which nobody knows how large it becomes. Its memory is doubled by reserve_large().
template<class T>
void append_large(std::vector<T>& v, const std::type_identity_t<T>& x) {
  if (v.size() == v.capacity()) reserve_large(v, v.size() + v.size() + 1);
  v.push_back(x);
}

/// A vector of n equal values.
template<class T>
std::vector<T> large_vector(std::size_t n, const T& value) {
  std::vector<T> v;
  reserve_pages(v, n);
  v.assign(n, value);
  return v;
}

/// The same without room for more, for arrays that are kept.
template<class T>
std::vector<T> exact_vector(std::size_t n, const T& value) {
  std::vector<T> v;
  reserve_exact(v, n);
  request_pages(v.data(), n * sizeof(T));
  v.assign(n, value);
  return v;
}

/// Resizes a vector to n elements or some more, so that those at its end can be assigned one after another, which takes less time than push_back.
/// trim() ends this.
template<class T>
void make_room(std::vector<T>& v, std::size_t n) {
  if (n <= v.size()) return;
  if (n > v.capacity()) reserve_large(v, n > v.size() + v.size() ? n : v.size() + v.size());
  const std::size_t before = v.size(), size = n + 65536 / sizeof(T) < v.capacity() ? n + 65536 / sizeof(T) : v.capacity();
  request_pages(v.data() + before, (size - before) * sizeof(T));
  v.resize(size);
}

/// Releases the memory of a vector.
template<class T>
void release(std::vector<T>& v) {
  std::vector<T>().swap(v);
}

/// Resizes a vector to n elements, and releases its memory if it has room for far more.
template<class T>
void trim(std::vector<T>& v, std::size_t n) {
  v.resize(n);
  if (v.capacity() > n + n / 2) v.shrink_to_fit();
}

}  // namespace concino::core
