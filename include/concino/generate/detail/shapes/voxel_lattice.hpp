// Cubic cells of equal size around a box, and the hexes of some of them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/arrays.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// A box of cubes, x fastest.
class voxel_lattice {
  vec3 low_, high_;
  std::array<std::size_t, 3> cells_{};

  double at(std::size_t axis, double i) const {
    const double t = i / static_cast<double>(cells_[axis]);
    return t == 1 ? high_[axis] : (1 - t) * low_[axis] + t * high_[axis];
  }

 public:
  /// Cubes of which n fit along the longest side of the box from `low` to `high`, and as many as are needed along the
  /// others, with the box in the middle.
  /// Errors: invalid_argument if n is 0, or if there would be too many cubes; invalid_mesh if the box is a point, or
  ///         too large for doubles.
  voxel_lattice(const char* caller, const vec3& low, const vec3& high, std::size_t n);

  std::size_t num_cells(std::size_t axis) const { return cells_[axis]; }
  std::size_t size() const { return cells_[0] * cells_[1] * cells_[2]; }
  double cell_size() const { return (high_.z - low_.z) / static_cast<double>(cells_[2]); }
  vec3 centre(std::size_t i, std::size_t j, std::size_t k) const {
    return {at(0, static_cast<double>(i) + 0.5), at(1, static_cast<double>(j) + 0.5),
            at(2, static_cast<double>(k) + 0.5)};
  }
  vec3 corner(std::size_t i, std::size_t j, std::size_t k) const {
    return {at(0, static_cast<double>(i)), at(1, static_cast<double>(j)), at(2, static_cast<double>(k))};
  }
};

/// The hexes of the cubes with a flag, which are numbered x fastest. Verts and hexes follow this order; verts of no hex
/// are left out.
cell_arrays voxels_as_hexes(const voxel_lattice& lattice, const std::vector<std::uint8_t>& flags);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/shapes/voxel_lattice.ipp>
#endif
