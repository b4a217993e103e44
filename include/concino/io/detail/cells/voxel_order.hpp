// The order of the corners of a box in which x changes fastest, then y, then z, as in voxels of VTK and hexes of
// geogram.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/support/standard_cells.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace concino::detail {

/// From either order to the other: corner k of a hex in the standard order is corner voxel_order[k] of the voxel, and
/// the reverse.
inline constexpr std::uint8_t voxel_order[8] = {0, 1, 3, 2, 4, 5, 7, 6};

inline std::array<vert_id, 8> swap_voxel_order(const vert_id* v) {
  std::array<vert_id, 8> r;
  for (unsigned k = 0; k < 8; ++k) r[k] = v[voxel_order[k]];
  return r;
}

/// Finds out in which of two orders hexes list their verts: in the wrong one, a hex intersects itself, and has a
/// smaller volume.
class hex_order_vote {
  int votes_ = 0;
  std::size_t num_hexes_ = 0;

 public:
  static constexpr std::size_t max_hexes = 1000;

  bool is_complete() const { return num_hexes_ == max_hexes; }
  void add(const vert_id* v, std::span<const vec3> points) {
    if (is_complete()) return;
    ++num_hexes_;
    const double standard = std::abs(six_times_volume(cell_shape::hex, v, points)),
                 voxel = std::abs(six_times_volume(cell_shape::hex, swap_voxel_order(v).data(), points));
    votes_ += standard > voxel ? 1 : standard < voxel ? -1 : 0;
  }
  /// Whether most of the hexes are in the standard order, rather than that of voxels.
  bool is_standard() const { return votes_ > 0; }
};

/// In a .tet file, a comment that says that hexes are in the order of voxels although their volumes suggest the other
/// one.
inline constexpr std::string_view voxel_order_comment = "# hexes in the order of voxels";

}  // namespace concino::detail
