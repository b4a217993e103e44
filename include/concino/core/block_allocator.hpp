// block_allocator: an allocator for many arrays that are returned together. They lie one after another in a few blocks in large pages.
#pragma once

#include <concino/core/temporary_array.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>

namespace concino::core {

/// Memory that is taken piece by piece, by any thread, and released as a whole.
class memory_block {
  temporary_array<std::byte> memory_;
  std::atomic<std::size_t> used_{0};

 public:
  explicit memory_block(std::size_t bytes) : memory_(bytes) {}

  /// Null if there is no room. Needs: alignment: a power of two.
  void* take(std::size_t bytes, std::size_t alignment) noexcept {
    const std::size_t most = bytes + alignment - 1;
    if (!has_room(most)) return nullptr;
    const std::size_t first = used_.fetch_add(most, std::memory_order_relaxed);
    if (first > memory_.capacity() || memory_.capacity() - first < most) return nullptr;
    const std::uintptr_t misaligned = reinterpret_cast<std::uintptr_t>(memory_.data() + first) & (alignment - 1);
    return memory_.data() + first + (misaligned ? alignment - misaligned : 0);
  }
  bool has_room(std::size_t bytes) const {
    const std::size_t used = used_.load(std::memory_order_relaxed);
    return used <= memory_.capacity() && memory_.capacity() - used >= bytes;
  }
  bool contains(const void* p) const {
    return reinterpret_cast<std::uintptr_t>(p) - reinterpret_cast<std::uintptr_t>(memory_.data()) < memory_.capacity();
  }
};

/// Takes arrays from a block, which lives as long as one of them, or from the heap if the block is full or if there is none. A copy of a container has
/// memory of its own.
template<class T>
class block_allocator {
  template<class> friend class block_allocator;
  std::shared_ptr<memory_block> block_;

 public:
  using value_type = T;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;

  block_allocator() = default;
  explicit block_allocator(std::shared_ptr<memory_block> block) noexcept : block_(std::move(block)) {}
  template<class U>
  block_allocator(const block_allocator<U>& o) noexcept : block_(o.block_) {}

  T* allocate(std::size_t n) {
    if (block_ && n < SIZE_MAX / 2 / sizeof(T))
      if (void* const p = block_->take(n * sizeof(T), alignof(T))) return static_cast<T*>(p);
    return std::allocator<T>().allocate(n);
  }
  void deallocate(T* p, std::size_t n) noexcept {
    if (!block_ || !block_->contains(p)) std::allocator<T>().deallocate(p, n);
  }
  block_allocator select_on_container_copy_construction() const { return {}; }
  template<class U>
  friend bool operator==(const block_allocator& a, const block_allocator<U>& b) noexcept { return a.is_of(b); }

 private:
  template<class U>
  bool is_of(const block_allocator<U>& o) const { return block_ == o.block_; }
};

}  // namespace concino::core
