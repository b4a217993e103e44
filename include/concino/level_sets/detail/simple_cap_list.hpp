// The caps of cells that a level set cuts simply, as a list.
#pragma once

#include <concino/concepts/mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Caps of some cells, as cycles of crossed edges, counter-clockwise seen from above.
template<class M>
struct simple_cap_list {
  std::vector<edge_t<M>> corners;
  std::vector<std::uint32_t> ends;       // by cap: where its corners end
  std::vector<std::uint32_t> cells;      // by cap
  std::vector<std::uint32_t> difficult;  // cells without caps, which are cut in another way
  bool meets_verts = false;              // some cell has a vert on the level set

  void truncate(std::size_t num_corners, std::size_t num_caps) { corners.resize(num_corners), ends.resize(num_caps), cells.resize(num_caps); }
};

}  // namespace concino::detail
