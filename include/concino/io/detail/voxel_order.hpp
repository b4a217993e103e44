// The order of the corners of a box in which x changes fastest, then y, then z, as in voxels of VTK and hexes of geogram.
#pragma once

#include <concino/concepts/descriptors.hpp>

#include <array>
#include <cstdint>

namespace concino::detail {

/// From either order to the other: corner k of a hex in the standard order is corner voxel_order[k] of the voxel, and the reverse.
inline constexpr std::uint8_t voxel_order[8] = {0, 1, 3, 2, 4, 5, 7, 6};

inline std::array<vert_id, 8> swap_voxel_order(const vert_id* v) {
  std::array<vert_id, 8> r;
  for (unsigned k = 0; k < 8; ++k) r[k] = v[voxel_order[k]];
  return r;
}

}  // namespace concino::detail
