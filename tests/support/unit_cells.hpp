// One cell of each standard shape.
#pragma once

#include <concino/mesh/support/standard_cells.hpp>

#include <vector>

namespace concino::testing {

inline const cell_shape shapes[] = {cell_shape::tet, cell_shape::hex, cell_shape::prism, cell_shape::pyramid};

/// One cell of each shape with unit edges, in the standard order.
inline std::vector<vec3> unit_cell(cell_shape s) {
  const std::vector<vec3> cube = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  if (s == cell_shape::tet) return {cube[0], cube[1], cube[3], cube[4]};
  if (s == cell_shape::prism) return {cube[0], cube[1], cube[3], cube[4], cube[5], cube[7]};
  if (s == cell_shape::pyramid) return {cube[0], cube[1], cube[2], cube[3], cube[4]};
  return cube;
}
inline double six_volumes_of(cell_shape s) {
  return s == cell_shape::tet ? 1 : s == cell_shape::prism ? 3 : s == cell_shape::pyramid ? 2 : 6;
}

}  // namespace concino::testing
