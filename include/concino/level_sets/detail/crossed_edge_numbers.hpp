// Numbers edges of a mesh in the order in which they come.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/block_allocator.hpp>
#include <concino/level_sets/detail/announced_numbers.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace concino::detail {

template<class M>
class crossed_edge_numbers {
  announced_numbers numbers_;
  std::vector<std::uint32_t> others_;  // numbers of other things, ascending

 public:
  std::vector<edge_t<M>, core::block_allocator<edge_t<M>>> edges;  // by number

  /// For edges of smaller indices, in a block of memory.
  crossed_edge_numbers(std::size_t bound, const std::shared_ptr<core::memory_block>& block) : numbers_(bound, block), edges(core::block_allocator<edge_t<M>>(block)) {}
  /// The bytes of the block that so many edges take.
  static std::size_t bytes_for(std::size_t bound, std::size_t n) { return announced_numbers::bytes_for(bound, n) + (n + 1) * sizeof(edge_t<M>); }

  /// Announces an edge that will be added.
  void announce(std::size_t index) { numbers_.announce(index); }
  /// Returns how many were announced. It must follow after all were.
  std::size_t count() {
    const std::size_t n = numbers_.count();
    edges.reserve(n);
    return n;
  }

  std::uint32_t add(const M& m, const edge_t<M>& e) {
    const std::uint32_t number = numbers_.add(index_of(m, e), edges.size());
    if (number == edges.size()) edges.push_back(e);
    return number;
  }
  /// A number for something else.
  std::uint32_t add_other() {
    others_.push_back(static_cast<std::uint32_t>(edges.size()));
    edges.push_back(edge_t<M>{});
    return others_.back();
  }
  bool is_edge(std::size_t number) const { return others_.empty() || !std::binary_search(others_.begin(), others_.end(), number); }
};

}  // namespace concino::detail
