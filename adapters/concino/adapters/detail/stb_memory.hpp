// Memory for stb that is freed whatever happens.
#pragma once

#include <concino/core/error.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <utility>

namespace concino::detail {

/// Owns the memory that stb allocates in this thread during the lifetime of this object. Without memory, stb would leak
/// or write to null; here std::bad_alloc is thrown out of stb, and the destructor frees what stb holds then.
class stb_memory {
  struct alignas(std::max_align_t) block {
    block *before, *after;
    void join() { before->after = after->before = this; }
  };
  block ring_{&ring_, &ring_};
  stb_memory* const outer_ = std::exchange(current(), this);

  // A pointer for the thread, since stb's functions cannot pass one on.
  static stb_memory*& current() {
    static thread_local stb_memory* memory = nullptr;
    return memory;
  }

 public:
  stb_memory() = default;
  stb_memory(const stb_memory&) = delete;
  stb_memory& operator=(const stb_memory&) = delete;
  ~stb_memory() {
    while (ring_.after != &ring_) free(ring_.after + 1);
    current() = outer_;
  }

  /// Resizes p, or allocates memory with zeros if p is null: stb does not set the pixels that a file which ends early
  /// lacks.
  static void* resized(void* p, std::size_t size) {
    block* const old = p ? static_cast<block*>(p) - 1 : nullptr;
    void* const memory = size > SIZE_MAX / 2 ? nullptr
                         : old               ? std::realloc(old, sizeof(block) + size)
                                             : std::calloc(1, sizeof(block) + size);
    auto* const b = static_cast<block*>(memory);
    if (!b) throw std::bad_alloc();
    if (!old) *b = {current()->ring_.before, &current()->ring_};
    b->join();
    return b + 1;
  }
  static void free(void* p) {
    if (!p) return;
    block* const b = static_cast<block*>(p) - 1;
    b->before->after = b->after;
    b->after->before = b->before;
    std::free(b);
  }
};

}  // namespace concino::detail
