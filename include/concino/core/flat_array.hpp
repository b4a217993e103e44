// flat_array: the array for all connectivity. It is like std::vector, but memory can be allocated without
// initialisation. It can take over a vector of the caller's as it is.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::core {

template<class T>
class flat_array {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t));

  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
  std::vector<T> adopted_;  // not empty: data_ is its memory

  void reallocate(std::size_t n) {
    if (n > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_alloc();
    const bool was_adopted = !adopted_.empty();
    void* const old = was_adopted ? nullptr : static_cast<void*>(data_);
    void* const p = std::realloc(old, n * sizeof(T));
    if (!p) throw std::bad_alloc();
    if (was_adopted) {
      std::memcpy(p, static_cast<const void*>(data_), std::min(n, size_) * sizeof(T));
      std::vector<T>().swap(adopted_);
    }
    data_ = static_cast<T*>(p);
    capacity_ = n;
  }
  /// Reallocates for n entries and some more: half as many as there are.
  void grow(std::size_t n) { reallocate(std::max(n, size_ + size_ / 2)); }

 public:
  flat_array() = default;
  /// n uninitialised entries.
  explicit flat_array(std::size_t n) { resize(n); }
  flat_array(std::size_t n, const T& value, std::size_t capacity = 0) {
    reserve(std::max(n, capacity));
    std::fill_n(data_, n, value);
    size_ = n;
  }
  explicit flat_array(std::vector<T> values) : adopted_(std::move(values)) {
    data_ = adopted_.data();
    size_ = capacity_ = adopted_.size();
  }
  /// A copy has the same capacity: what has grown by edits will probably be edited again.
  flat_array(const flat_array& o) {
    reserve(o.capacity_);
    std::copy_n(o.data_, o.size_, data_);
    size_ = o.size_;
  }
  flat_array(flat_array&& o) noexcept { swap(o); }
  flat_array& operator=(flat_array o) noexcept {
    swap(o);
    return *this;
  }
  ~flat_array() {
    if (adopted_.empty()) std::free(data_);
  }
  void swap(flat_array& o) noexcept {
    std::swap(data_, o.data_);
    std::swap(size_, o.size_);
    std::swap(capacity_, o.capacity_);
    adopted_.swap(o.adopted_);
  }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }

  void reserve(std::size_t n) {
    if (n > capacity_) reallocate(n);
  }
  /// New entries are uninitialised.
  void resize(std::size_t n) {
    reserve(n);
    size_ = n;
  }
  void push_back(const T& value) {
    const T kept = value;  // a copy: value may be in this array
    if (size_ == capacity_) grow(16);
    data_[size_++] = kept;
  }
  /// Reserves memory for n more entries and returns their address; resize() makes them part of the array.
  T* reserve_back(std::size_t n) {
    if (size_ + n > capacity_) grow(size_ + n);
    return data_ + size_;
  }
  /// Writes n values behind the last, or none if `first` is null, after reserving memory for `room` >= n more. The
  /// values may be in this array; resize() makes them part of it.
  T* stage(const T* first, std::size_t n, std::size_t room) {
    if (size_ + room > capacity_) {
      const std::size_t at = reinterpret_cast<std::uintptr_t>(first) - reinterpret_cast<std::uintptr_t>(data_);
      const bool own = at < size_ * sizeof(T);
      grow(size_ + room);
      if (own) first = data_ + at / sizeof(T);
    }
    if (first) std::copy_n(first, n, data_ + size_);
    return data_ + size_;
  }
  /// Appends n values, which may be in this array.
  void append(const T* first, std::size_t n) {
    stage(first, n, n);
    size_ += n;
  }
  void shrink_to_fit() {
    if (size_ == capacity_) return;
    if (size_ == 0) *this = {};
    else reallocate(size_);
  }
};

}  // namespace concino::core
