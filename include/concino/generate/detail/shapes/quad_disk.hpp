// A disk of quads.
#pragma once

#include <concino/generate/detail/shapes/box_surface.hpp>
#include <concino/generate/detail/shapes/round.hpp>

#include <vector>

namespace concino::detail {

/// A disk of radius 1 in x and y, counter-clockwise: a core of n x n quads, surrounded by layers of quads. The last 4 n
/// verts are on the circle, in equal angles, counter-clockwise.
inline surface_arrays quad_disk(std::size_t n) {
  const std::size_t layers = layers_around(n), row = n + 1, core = row * row, perimeter = 4 * n;
  surface_arrays a{{}, {}, {}, 4};
  const auto square = [&](const grid_corner& at) { return vec3(even_angle(at[0], n), even_angle(at[1], n), 0); };
  std::vector<grid_corner> around(perimeter);
  for (std::size_t j = 0; j < row; ++j)
    for (std::size_t i = 0; i < row; ++i) {
      a.points.push_back(in_round_core(square({i, j, 0})));
      if (i == 0 || i == n || j == 0 || j == n) around[boundary_cycle_number(i, j, n, n)] = {i, j, 0};
      if (i == n || j == n) continue;
      for (const std::size_t step : {std::size_t{0}, std::size_t{1}, row + 1, row})
        a.verts.push_back(vert_id{j * row + i + step});
    }
  const auto number = [&](std::size_t layer, std::size_t k) {
    return layer == 0 ? around[k][1] * row + around[k][0] : core + (layer - 1) * perimeter + k;
  };
  for (std::size_t l = 1; l <= layers; ++l)
    for (std::size_t k = 0; k < perimeter; ++k) {
      const vec3 u = square(around[k]), inner = in_round_core(u), outer = on_round_boundary(u);
      a.points.push_back(
          l == layers ? outer : inner + (static_cast<double>(l) / static_cast<double>(layers)) * (outer - inner));
      const std::size_t next = (k + 1) % perimeter;
      for (const std::size_t v : {number(l - 1, k), number(l, k), number(l, next), number(l - 1, next)})
        a.verts.push_back(vert_id{v});
    }
  return a;
}

}  // namespace concino::detail
