// temporary_array: a large array for a short time, which the system gives and takes back in large pages.
#pragma once

#include <concino/core/large_pages.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace concino::core {

/// An array of numbers that is not kept. malloc() writes a header before an array, so that the first 2 MiB of any array get small pages, which takes the
/// system four times as long as one large page. This array has no header: it is mapped as it is, in large pages, unless it is far smaller than one.
template<class T>
class temporary_array {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  T* data_ = nullptr;
  std::size_t capacity_ = 0;
  std::size_t mapped_ = 0;  // bytes; 0: the array is on the heap

  /// The size of the mapping for an array of so many bytes: whole large pages, at most four times as large as the array. 0: it is no mapping.
  static std::size_t mapping_of([[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
    constexpr std::size_t page = std::size_t{1} << 21;
    if (bytes > page / 4 && bytes < ~std::size_t{0} / 2) return (bytes + page - 1) & ~(page - 1);
#endif
    return 0;
  }
  void release() {
#if defined(__linux__)
    if (mapped_) ::munmap(static_cast<void*>(data_), mapped_);
#endif
    if (!mapped_) ::operator delete(static_cast<void*>(data_));
  }

 public:
  temporary_array() = default;
  /// An array of at least n numbers without values. Errors: std::bad_alloc.
  explicit temporary_array(std::size_t n) : mapped_(mapping_of(n * sizeof(T))) {
    if (n > ~std::size_t{0} / 2 / sizeof(T)) throw std::bad_alloc();
#if defined(__linux__)
    if (mapped_) {
      void* const p = ::mmap(nullptr, mapped_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
      if (p == MAP_FAILED) throw std::bad_alloc();
      ::madvise(p, mapped_, MADV_HUGEPAGE);
      *static_cast<unsigned char*>(p) = 0;  // if two threads were the first to write to a large page, both would clear one
      data_ = static_cast<T*>(p);
    }
#endif
    if (!mapped_) data_ = static_cast<T*>(::operator new(n * sizeof(T)));
    capacity_ = mapped_ ? mapped_ / sizeof(T) : n;
  }
  /// n equal values.
  temporary_array(std::size_t n, const T& value) : temporary_array(n) { std::uninitialized_fill_n(data_, n, value); }
  temporary_array(temporary_array&& o) noexcept { swap(o); }
  temporary_array& operator=(temporary_array&& o) noexcept {
    swap(o);
    return *this;
  }
  ~temporary_array() { release(); }
  void swap(temporary_array& o) noexcept {
    std::swap(data_, o.data_);
    std::swap(capacity_, o.capacity_);
    std::swap(mapped_, o.mapped_);
  }

  T* data() { return data_; }
  const T* data() const { return data_; }
  /// How many numbers there is room for.
  std::size_t capacity() const { return capacity_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
};

}  // namespace concino::core
