// The surface of a box of cells: its verts, numbered, and its quads.
#pragma once

#include <array>
#include <cstddef>

namespace concino::detail {

using grid_corner = std::array<std::size_t, 3>;

/// The position of corner (i, j) in the boundary cycle of nx x ny cells, counter-clockwise from (0, 0).
constexpr std::size_t boundary_cycle_number(std::size_t i, std::size_t j, std::size_t nx, std::size_t ny) {
  if (j == 0) return i;
  if (i == nx) return nx + j;
  if (j == ny) return 2 * nx + ny - i;
  return 2 * nx + 2 * ny - j;
}

class box_surface {
  grid_corner n_;
  std::size_t lid_, boundary_cycle_;  // number of verts of the lowest layer, which is full, and of each layer between,
                                      // a boundary cycle

 public:
  explicit constexpr box_surface(const grid_corner& cells)
      : n_(cells), lid_((cells[0] + 1) * (cells[1] + 1)), boundary_cycle_(2 * (cells[0] + cells[1])) {}

  constexpr std::size_t num_verts() const { return 2 * lid_ + (n_[2] - 1) * boundary_cycle_; }
  constexpr std::size_t num_quads() const { return 2 * (n_[0] * n_[1] + n_[1] * n_[2] + n_[2] * n_[0]); }

  constexpr std::size_t number(const grid_corner& at) const {
    const auto [i, j, k] = at;
    if (k > 0 && k < n_[2]) return lid_ + (k - 1) * boundary_cycle_ + boundary_cycle_number(i, j, n_[0], n_[1]);
    return (k == 0 ? 0 : lid_ + (n_[2] - 1) * boundary_cycle_) + j * (n_[0] + 1) + i;
  }

  template<class F>
  void for_each_vert(F&& f) const {  // in the order of the numbers
    const auto [nx, ny, nz] = n_;
    for (std::size_t k = 0; k <= nz; ++k) {
      if (k == 0 || k == nz) {
        for (std::size_t j = 0; j <= ny; ++j)
          for (std::size_t i = 0; i <= nx; ++i) f(grid_corner{i, j, k});
        continue;
      }
      for (std::size_t i = 0; i < nx; ++i) f(grid_corner{i, 0, k});
      for (std::size_t j = 0; j < ny; ++j) f(grid_corner{nx, j, k});
      for (std::size_t i = nx; i > 0; --i) f(grid_corner{i, ny, k});
      for (std::size_t j = ny; j > 0; --j) f(grid_corner{0, j, k});
    }
  }

  /// Calls f with the four corners of each quad, counter-clockwise as seen from outside.
  template<class F>
  void for_each_quad(F&& f) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool high : {false, true}) {
        const std::size_t u = high ? (axis + 1) % 3 : (axis + 2) % 3, v = 3 - axis - u;
        grid_corner at{};
        at[axis] = high ? n_[axis] : 0;
        for (at[v] = 0; at[v] < n_[v]; ++at[v])
          for (at[u] = 0; at[u] < n_[u]; ++at[u]) {
            std::array<grid_corner, 4> quad{at, at, at, at};
            ++quad[1][u], ++quad[2][u], ++quad[2][v], ++quad[3][v];
            f(quad);
          }
      }
  }
};

}  // namespace concino::detail
