// The caps of cells that a level set cuts simply, as a list.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/block_allocator.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace concino::detail {

/// Caps of some cells, as cycles of crossed edges, counter-clockwise seen from above.
template<class M>
struct simple_cap_list {
  template<class T> using array = std::vector<T, core::block_allocator<T>>;
  static constexpr std::size_t bytes_per_cell = 4 * sizeof(edge_t<M>) + 2 * sizeof(std::uint32_t);

  array<edge_t<M>> corners;
  array<std::uint32_t> ends;             // by cap: where its corners end
  array<std::uint32_t> cells;            // by cap
  std::vector<std::uint32_t> difficult;  // cells without caps, which are cut in another way
  bool meets_verts = false;              // some cell has a vert on the level set

  simple_cap_list() = default;
  /// With room for n cells of one cap with four corners each, in a block of memory.
  simple_cap_list(std::size_t n, const std::shared_ptr<core::memory_block>& block)
      : corners(core::block_allocator<edge_t<M>>(block)), ends(core::block_allocator<std::uint32_t>(block)), cells(core::block_allocator<std::uint32_t>(block)) {
    corners.reserve(4 * n), ends.reserve(n), cells.reserve(n);
  }

  void truncate(std::size_t num_corners, std::size_t num_caps) { corners.resize(num_corners), ends.resize(num_caps), cells.resize(num_caps); }
};

}  // namespace concino::detail
