// A table of the sections of MEDIT files, text and binary.
#pragma once

#include <concino/mesh/support/standard_cells.hpp>

#include <cstdint>
#include <string_view>

namespace concino::detail {

/// What the rows of a section are.
enum class medit_rows : std::uint8_t {
  polygons,
  cells,
  edges,
  marked_verts,
  marked_edges,
  marked_polygons,
  normals,
  normals_at_verts
};

struct medit_section {
  std::string_view keyword;
  std::int32_t code;         // in binary files
  medit_rows rows;
  std::uint32_t arity;       // the number of indices of a row
  cell_shape shape;          // of cells
  const char* mark;          // the property that is 1 at the elements that the rows name; else null
  std::uint32_t nodes = 0;   // the number of indices after those, of nodes of elements of second or higher order

  bool is_volume() const { return rows == medit_rows::cells; }
  bool has_reference() const { return rows <= medit_rows::edges; }
  std::uint32_t num_indices() const { return arity + nodes; }
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

/// Elements of second and higher order. Their corners come first.
inline constexpr medit_section high_order_medit_sections[] = {
    {"EdgesP2", 25, medit_rows::edges, 2, cell_shape::general, nullptr, 1},
    {"EdgesP3", 92, medit_rows::edges, 2, cell_shape::general, nullptr, 2},
    {"EdgesP4", 93, medit_rows::edges, 2, cell_shape::general, nullptr, 3},
    {"TrianglesP2", 24, medit_rows::polygons, 3, cell_shape::general, nullptr, 3},
    {"TrianglesP3", 90, medit_rows::polygons, 3, cell_shape::general, nullptr, 7},
    {"TrianglesP4", 91, medit_rows::polygons, 3, cell_shape::general, nullptr, 12},
    {"QuadrilateralsQ2", 27, medit_rows::polygons, 4, cell_shape::general, nullptr, 5},
    {"QuadrilateralsQ3", 88, medit_rows::polygons, 4, cell_shape::general, nullptr, 12},
    {"QuadrilateralsQ4", 89, medit_rows::polygons, 4, cell_shape::general, nullptr, 21},
    {"TetrahedraP2", 30, medit_rows::cells, 4, cell_shape::tet, nullptr, 6},
    {"TetrahedraP3", 96, medit_rows::cells, 4, cell_shape::tet, nullptr, 16},
    {"TetrahedraP4", 97, medit_rows::cells, 4, cell_shape::tet, nullptr, 31},
    {"HexahedraQ2", 33, medit_rows::cells, 8, cell_shape::hex, nullptr, 19},
    {"HexahedraQ3", 98, medit_rows::cells, 8, cell_shape::hex, nullptr, 56},
    {"HexahedraQ4", 99, medit_rows::cells, 8, cell_shape::hex, nullptr, 117},
    {"PrismsP2", 86, medit_rows::cells, 6, cell_shape::prism, nullptr, 12},
    {"PrismsP3", 102, medit_rows::cells, 6, cell_shape::prism, nullptr, 34},
    {"PrismsP4", 103, medit_rows::cells, 6, cell_shape::prism, nullptr, 69},
    {"PyramidsP2", 87, medit_rows::cells, 5, cell_shape::pyramid, nullptr, 9},
    {"PyramidsP3", 100, medit_rows::cells, 5, cell_shape::pyramid, nullptr, 25},
    {"PyramidsP4", 101, medit_rows::cells, 5, cell_shape::pyramid, nullptr, 50},
};

/// The section with this keyword or code; null if it is in neither table.
template<class Name>
const medit_section* find_medit_section(Name medit_section::* member, const Name& name) {
  for (const medit_section& s : medit_sections)
    if (s.*member == name) return &s;
  for (const medit_section& s : high_order_medit_sections)
    if (s.*member == name) return &s;
  return nullptr;
}

/// Whether a section lists the order of nodes in elements: corners need not come first then. The codes are those of
/// EdgesP2Ordering and the other ones.
inline bool is_medit_ordering(std::string_view keyword) { return keyword.ends_with("Ordering"); }
inline bool is_medit_ordering(std::int32_t code) { return code >= 127 && code <= 154; }

/// Codes of binary files that are not in the table.
inline constexpr std::int32_t medit_dimension_code = 3, medit_vertices_code = 4, medit_end_code = 54;

/// Which section of a file it is, and where its rows are.
struct medit_section_header {
  const medit_section* section = nullptr;  // null: Vertices
  const char* at = nullptr;                // its first row
  std::uint64_t count = 0;                 // of its rows
};

/// Whether a text begins like a binary MEDIT file: with the numbers 1 and 1 to 4, in either byte order.
inline bool is_binary_medit(std::string_view text) {
  if (text.size() < 8) return false;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const bool little = byte(0) == 1 && !byte(1) && !byte(2) && !byte(3) && byte(4) >= 1 && byte(4) <= 4 && !byte(5) &&
                      !byte(6) && !byte(7);
  const bool big = byte(3) == 1 && !byte(0) && !byte(1) && !byte(2) && byte(7) >= 1 && byte(7) <= 4 && !byte(4) &&
                   !byte(5) && !byte(6);
  return little || big;
}

}  // namespace concino::detail
