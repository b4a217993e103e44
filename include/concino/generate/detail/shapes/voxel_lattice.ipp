// Bodies of voxel_lattice.hpp: cubic cells of equal size around a box, and the hexes of some of them.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/generate/detail/shapes/voxel_lattice.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

CONCINO_INLINE voxel_lattice::voxel_lattice(const char* caller, const vec3& low, const vec3& high, std::size_t n)
    : low_(low), high_(high) {
  if (n == 0) core::throw_joined<invalid_argument>({caller, ": n is 0; it must be at least 1"});
  const vec3 extent = high - low;
  const double longest = std::max({extent.x, extent.y, extent.z});
  if (!(longest > 0 && longest <= std::numeric_limits<double>::max()))
    core::throw_joined<invalid_mesh>(
        {caller, ": the surface has the size ", core::number_text(longest), "; it must be finite and above 0"});
  const double size = longest / static_cast<double>(n);
  double count = 1, vert_count = 1;
  for (const std::size_t k : {0u, 1u, 2u}) {
    const double needed = extent[k] / size,
                 cells = extent[k] == longest ? static_cast<double>(n) : std::max(1.0, std::ceil(needed - 1e-9));
    count *= cells, vert_count *= cells + 1;
    if (!(count < 1073741823.0 && vert_count < 4294967295.0))
      core::throw_joined<invalid_argument>(
          {caller, ": n is ", n, ", which asks for more than 2^30 cubes; choose a smaller one"});
    cells_[k] = static_cast<std::size_t>(cells);
    if (std::abs(needed - cells) < 1e-9) continue;  // the box has the size of the cubes
    const double middle = low[k] + extent[k] / 2;
    low_[k] = middle - cells * size / 2, high_[k] = middle + cells * size / 2;
  }
}

/// The numbers of the verts of two levels of a lattice, the lower one first.
class level_numbers {
  static constexpr std::uint32_t none = ~0u;
  std::size_t row_;
  std::vector<std::uint32_t> number_[2];

 public:
  level_numbers(std::size_t nx, std::size_t ny)
      : row_(nx + 1), number_{std::vector<std::uint32_t>(row_ * (ny + 1), none),
                              std::vector<std::uint32_t>(row_ * (ny + 1), none)} {}

  std::uint32_t& at(std::size_t level, std::size_t i, std::size_t j) { return number_[level][j * row_ + i]; }
  void next_level() {
    std::swap(number_[0], number_[1]);
    std::fill(number_[1].begin(), number_[1].end(), none);
  }
};

/// Numbers the verts of level k, those of cubes below or above it.
CONCINO_INLINE void number_level(const voxel_lattice& lattice, const std::vector<std::uint8_t>& flags, std::size_t k,
                                 std::size_t level, level_numbers& numbers, std::vector<vec3>& points) {
  const std::size_t nx = lattice.num_cells(0), ny = lattice.num_cells(1), nz = lattice.num_cells(2);
  const auto has = [&](std::size_t i, std::size_t j) {
    return (k < nz && flags[(k * ny + j) * nx + i]) || (k > 0 && flags[((k - 1) * ny + j) * nx + i]);
  };
  for (std::size_t j = 0; j <= ny; ++j)
    for (std::size_t i = 0; i <= nx; ++i) {
      bool is_used = false;
      for (std::size_t b = j == 0 ? 0 : j - 1; b < std::min(j + 1, ny); ++b)
        for (std::size_t a = i == 0 ? 0 : i - 1; a < std::min(i + 1, nx); ++a) is_used = is_used || has(a, b);
      if (!is_used) continue;
      numbers.at(level, i, j) = static_cast<std::uint32_t>(points.size());
      points.push_back(lattice.corner(i, j, k));
    }
}

CONCINO_INLINE cell_arrays voxels_as_hexes(const voxel_lattice& lattice, const std::vector<std::uint8_t>& flags) {
  const std::size_t nx = lattice.num_cells(0), ny = lattice.num_cells(1), nz = lattice.num_cells(2);
  cell_arrays a{{}, {}, 8};
  a.verts.reserve(8 * static_cast<std::size_t>(std::count(flags.begin(), flags.end(), std::uint8_t{1})));
  level_numbers numbers(nx, ny);
  number_level(lattice, flags, 0, 1, numbers, a.points);
  for (std::size_t k = 0; k < nz; ++k) {
    numbers.next_level();
    number_level(lattice, flags, k + 1, 1, numbers, a.points);
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i) {
        if (!flags[(k * ny + j) * nx + i]) continue;
        for (const std::size_t level : {0u, 1u})
          for (const std::uint32_t v : {numbers.at(level, i, j), numbers.at(level, i + 1, j),
                                        numbers.at(level, i + 1, j + 1), numbers.at(level, i, j + 1)})
            a.verts.push_back(vert_id{v});
      }
  }
  return a;
}

}  // namespace concino::detail
