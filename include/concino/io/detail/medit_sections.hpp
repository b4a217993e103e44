// A table of the sections of MEDIT files, text and binary.
#pragma once

#include <concino/mesh/standard_cells.hpp>

#include <cstdint>
#include <string_view>

namespace concino::detail {

/// What the rows of a section are.
enum class medit_rows : std::uint8_t { polygons, cells, edges, marked_verts, marked_edges, marked_polygons, normals, normals_at_verts };

struct medit_section {
  std::string_view keyword;
  std::int32_t code;         // in binary files
  medit_rows rows;
  std::uint32_t arity;       // the number of indices of a row
  cell_shape shape;          // of cells
  const char* mark;          // the property that is 1 at the elements that the rows name; else null

  bool is_volume() const { return rows == medit_rows::cells; }
  bool has_reference() const { return rows <= medit_rows::edges; }
};

/// The first six are those of polys, in the order in which they are written.
inline constexpr medit_section medit_sections[] = {
    {"Triangles", 6, medit_rows::polygons, 3, cell_shape::general, nullptr},
    {"Quadrilaterals", 7, medit_rows::polygons, 4, cell_shape::general, nullptr},
    {"Tetrahedra", 8, medit_rows::cells, 4, cell_shape::tet, nullptr},
    {"Hexahedra", 10, medit_rows::cells, 8, cell_shape::hex, nullptr},
    {"Prisms", 9, medit_rows::cells, 6, cell_shape::prism, nullptr},
    {"Pyramids", 49, medit_rows::cells, 5, cell_shape::pyramid, nullptr},
    {"Edges", 5, medit_rows::edges, 2, cell_shape::general, nullptr},
    {"Corners", 13, medit_rows::marked_verts, 1, cell_shape::general, "corner"},
    {"RequiredVertices", 15, medit_rows::marked_verts, 1, cell_shape::general, "required"},
    {"Ridges", 14, medit_rows::marked_edges, 1, cell_shape::general, "ridge"},
    {"RequiredEdges", 16, medit_rows::marked_edges, 1, cell_shape::general, "required"},
    {"RequiredTriangles", 17, medit_rows::marked_polygons, 1, cell_shape::general, "required"},
    {"RequiredQuadrilaterals", 18, medit_rows::marked_polygons, 1, cell_shape::general, "required"},
    {"Normals", 60, medit_rows::normals, 0, cell_shape::general, nullptr},
    {"NormalAtVertices", 20, medit_rows::normals_at_verts, 2, cell_shape::general, nullptr},
};

/// Codes of binary files that are not in the table.
inline constexpr std::int32_t medit_dimension_code = 3, medit_vertices_code = 4, medit_end_code = 54;

/// A section that was found in a file.
struct medit_part {
  const medit_section* section = nullptr;  // null: Vertices
  const char* at = nullptr;                // its first row
  std::uint64_t count = 0;                 // of its rows
};

/// Whether a text begins like a binary MEDIT file: with the numbers 1 and 1 to 4, in either byte order.
inline bool is_binary_medit(std::string_view text) {
  if (text.size() < 8) return false;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const bool little = byte(0) == 1 && !byte(1) && !byte(2) && !byte(3) && byte(4) >= 1 && byte(4) <= 4 && !byte(5) && !byte(6) && !byte(7);
  const bool big = byte(3) == 1 && !byte(0) && !byte(1) && !byte(2) && byte(7) >= 1 && byte(7) <= 4 && !byte(4) && !byte(5) && !byte(6);
  return little || big;
}

}  // namespace concino::detail
