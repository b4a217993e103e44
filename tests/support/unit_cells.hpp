// One cell of each standard shape.
#pragma once

#include <concino/mesh/standard_cells.hpp>

#include <vector>

namespace concino::testing {

inline const detail::cell_shape shapes[] = {detail::cell_shape::tet, detail::cell_shape::hex, detail::cell_shape::prism, detail::cell_shape::pyramid};

/// One cell of each shape with unit edges, in the standard order.
inline std::vector<vec3> unit_cell(detail::cell_shape s) {
  using detail::cell_shape;
  const std::vector<vec3> cube = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  if (s == cell_shape::tet) return {cube[0], cube[1], cube[3], cube[4]};
  if (s == cell_shape::prism) return {cube[0], cube[1], cube[3], cube[4], cube[5], cube[7]};
  if (s == cell_shape::pyramid) return {cube[0], cube[1], cube[2], cube[3], cube[4]};
  return cube;
}
inline double six_volumes_of(detail::cell_shape s) {
  using detail::cell_shape;
  return s == cell_shape::tet ? 1 : s == cell_shape::prism ? 3 : s == cell_shape::pyramid ? 2 : 6;
}

}  // namespace concino::testing
