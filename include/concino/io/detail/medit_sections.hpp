// A table of the sections of MEDIT files that hold polys.
#pragma once

#include <concino/mesh/standard_cells.hpp>

#include <string_view>

namespace concino::detail {

struct medit_section {
  std::string_view keyword;
  bool volume;
  std::uint32_t arity;
  cell_shape shape;
};
inline constexpr medit_section medit_sections[] = {
    {"Triangles", false, 3, cell_shape::general}, {"Quadrilaterals", false, 4, cell_shape::general},
    {"Tetrahedra", true, 4, cell_shape::tet},     {"Hexahedra", true, 8, cell_shape::hex},
    {"Prisms", true, 6, cell_shape::prism},       {"Pyramids", true, 5, cell_shape::pyramid},
};

}  // namespace concino::detail
