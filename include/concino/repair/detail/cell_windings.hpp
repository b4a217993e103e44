// Decides which cells of a volume to turn.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/repair/detail/repair_log.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The faces of each cell, one after another, and whether each is outward for it.
struct cell_faces {
  std::vector<std::uint32_t> offsets{0}, faces;
  std::vector<std::uint8_t> outward;
  std::size_t num_faces = 0;

  std::size_t num_cells() const { return offsets.size() - 1; }
};

/// Which cells have to be turned, so that cells that share a face have their outside on different sides of it, and as
/// few as possible have negative volume, and then as few as possible are turned. sign: by cell, of its volume, or 0 if
/// it has none. Cells that remain inverted, and components that allow no winding, are logged by their origins.
std::vector<std::uint8_t> cells_to_turn(const cell_faces& cells, const std::vector<std::int8_t>& sign,
                                        const std::vector<std::uint32_t>& origin, repair_log& log);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/repair/detail/cell_windings.ipp>
#endif
