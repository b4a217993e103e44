// small_array: an array that needs no allocation while it is small, for lists of a few elements that are made often.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace concino::core {

/// Like std::vector, for plain values: the first N are stored in the array itself.
template<class T, std::size_t N>
class small_array {
  static_assert(std::is_trivially_copyable_v<T>);

  alignas(T) std::byte inside_[N * sizeof(T)];  // no values are constructed before they are needed
  std::unique_ptr<T[]> outside_;                // null, or all values
  T* data_ = reinterpret_cast<T*>(inside_);
  std::size_t size_ = 0, capacity_ = N;

  void grow(std::size_t n) {
    n = std::max(n, 2 * capacity_);
    std::unique_ptr<T[]> more(new T[n]);  // not std::make_unique_for_overwrite, which libc++ has since version 16
    std::copy_n(data_, size_, more.get());
    outside_ = std::move(more);
    data_ = outside_.get();
    capacity_ = n;
  }

 public:
  small_array() = default;
  small_array(std::size_t n, const T& value) { resize(n, value); }
  small_array(const small_array&) = delete;
  small_array& operator=(const small_array&) = delete;

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  bool empty() const { return size_ == 0; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T& back() { return data_[size_ - 1]; }

  void clear() { size_ = 0; }
  void reserve(std::size_t n) {
    if (n > capacity_) grow(n);
  }
  void push_back(const T& value) {
    const T kept = value;  // a copy: value may be in this array
    if (size_ == capacity_) grow(size_ + 1);
    data_[size_++] = kept;
  }
  /// New values are copies of `value`.
  void resize(std::size_t n, const T& value) {
    const T kept = value;
    reserve(n);
    if (n > size_) std::fill(data_ + size_, data_ + n, kept);
    size_ = n;
  }
};

}  // namespace concino::core
