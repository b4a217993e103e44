// memory_blocks: the blocks from which the arrays of one call are taken.
#pragma once

#include <concino/core/block_allocator.hpp>

#include <cstddef>
#include <memory>
#include <mutex>

namespace concino::core {

/// The blocks of one call, for any thread.
class memory_blocks {
  static constexpr std::size_t max_size = std::size_t{1} << 22;
  std::mutex mutex_;
  std::shared_ptr<memory_block> last_;

 public:
  /// A block with room for an array of so many bytes, one of about `num_arrays` of the same size. Errors: std::bad_alloc.
  std::shared_ptr<memory_block> block_for(std::size_t bytes, std::size_t num_arrays) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (last_ && last_->has_room(bytes)) return last_;
    const std::size_t all = bytes > 0 && num_arrays > max_size / bytes ? max_size : bytes * num_arrays;
    return last_ = std::make_shared<memory_block>(all > bytes ? all : bytes);
  }
};

}  // namespace concino::core
