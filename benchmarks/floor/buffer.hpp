// An array for the floors: it grows without a copy where the system can move pages, and new memory is not filled with zeros.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

namespace bench::floors {

using u32 = std::uint32_t;
inline constexpr u32 none = ~u32{0};

template<class T>
class buffer {
  static_assert(std::is_trivially_copyable_v<T>);
  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;

  void reallocate(std::size_t n) {
    void* p = std::realloc(static_cast<void*>(data_), (n ? n : 1) * sizeof(T));
    if (!p) throw std::bad_alloc();
    data_ = static_cast<T*>(p);
    capacity_ = n;
  }

 public:
  buffer() = default;
  explicit buffer(std::size_t n) { resize(n); }
  buffer(std::size_t n, int byte) : buffer(n) { std::memset(static_cast<void*>(data_), byte, n * sizeof(T)); }
  buffer(buffer&& o) noexcept
      : data_(std::exchange(o.data_, nullptr)), size_(std::exchange(o.size_, 0)), capacity_(std::exchange(o.capacity_, 0)) {}
  buffer& operator=(buffer&& o) noexcept {
    std::swap(data_, o.data_);
    std::swap(size_, o.size_);
    std::swap(capacity_, o.capacity_);
    return *this;
  }
  ~buffer() { std::free(data_); }

  void reserve(std::size_t n) { if (n > capacity_) reallocate(n); }
  void resize(std::size_t n) { reserve(n); size_ = n; }
  void shrink() { if (size_ != capacity_) reallocate(size_); }
  void push(T x) {
    if (size_ == capacity_) reallocate(capacity_ ? 2 * capacity_ : 1024);
    data_[size_++] = x;
  }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  std::size_t bytes() const { return size_ * sizeof(T); }
};

/// Turns the counts of the rows, stored at offsets[row + 1], into the offsets of the rows.
inline void prefix_sum(buffer<u32>& offsets) {
  for (std::size_t i = 1; i < offsets.size(); ++i) offsets[i] += offsets[i - 1];
}

}  // namespace bench::floors
