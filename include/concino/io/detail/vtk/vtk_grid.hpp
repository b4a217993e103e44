// The contents of a file of VTK, .vtk, .vtu or .vtp, as flat arrays.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/file_contents.hpp>
#include <concino/mesh/support/standard_cells.hpp>

#include <string>
#include <utility>
#include <vector>

namespace concino::detail {

/// A grid: points, cells of many types, and their values.
struct vtk_grid {
  static constexpr std::uint32_t unknown = ~0u;
  std::vector<vec3> points;
  std::vector<vert_id> verts;            // of all cells, unchecked; of a polyhedron its faces: their number, and for
                                         // each the number of its verts and these
  std::vector<std::uint32_t> cell_ends;  // where the verts of each cell end
  std::vector<std::uint8_t> types;       // VTK's number of the type of each cell
  std::vector<property_column> columns;  // of verts, of all cells (element_kind::poly) and of the mesh
  std::uint32_t largest = unknown;       // number in verts, or more
  std::uint64_t num_ghosts = 0;          // cells that were dropped

  std::size_t size() const { return types.size(); }
  std::size_t first(std::size_t cell) const { return cell ? cell_ends[cell - 1] : 0; }
};

/// Where the cells of a grid stand in its file, for errors.
struct vtk_places {
  /// Errors: parse_error that names the line or the byte of a cell.
  [[noreturn]] virtual void fail_at_cell(std::size_t cell, core::message expected, core::message found) = 0;
  /// "line 12" or "byte 345".
  virtual std::string place_of_cell(std::size_t cell) = 0;

 protected:
  ~vtk_places() = default;
};

/// What a cell type stands for.
enum class vtk_kind : std::uint8_t { none, line, polygon, cell, unknown };
inline constexpr unsigned vtk_polyhedron = 42;
/// The type of the cell with the same corners and no other nodes, for elements of second and higher order; else the
/// type itself.
inline unsigned linear_vtk_type(unsigned type) {
  // 21 to 37; 35 is cubic
  constexpr std::uint8_t quadratic[] = {3, 5, 9, 10, 12, 13, 14, 9, 12, 9, 13, 13, 12, 5, 3, 7, 14};
  constexpr std::uint8_t of_any_order[] = {3, 5, 9, 10, 12, 13, 14};  // Lagrange from 68 on, Bezier from 75 on
  if (type >= 21 && type <= 37) return quadratic[type - 21];
  return type >= 68 && type <= 81 ? of_any_order[(type - 68) % 7] : type;
}
inline vtk_kind kind_of_vtk_cell(unsigned type) {
  type = linear_vtk_type(type);
  if (type == 0) return vtk_kind::none;
  if (type <= 4) return vtk_kind::line;
  if (type <= 9) return vtk_kind::polygon;
  return type <= 16 || type == vtk_polyhedron ? vtk_kind::cell : vtk_kind::unknown;
}
/// The number of verts of a cell of this type; 0 if it varies.
inline std::size_t size_of_vtk_cell(unsigned type) {
  constexpr std::uint8_t sizes[] = {0, 1, 0, 2, 0, 3, 0,  0,  4,  4,  4, 8,  8, 6,  5,  10, 12, 0, 0,
                                    0, 0, 3, 6, 8, 10, 20, 15, 13, 9, 27, 6, 12, 18, 24, 7, 4, 0, 19};
  return type < std::size(sizes) ? sizes[type] : 0;
}
/// The shape of a standard cell of this type, or `general`.
inline cell_shape shape_of_vtk_cell(unsigned type) {
  switch (type) {
    case 10: return cell_shape::tet;
    case 11:
    case 12: return cell_shape::hex;
    case 13: return cell_shape::prism;
    case 14: return cell_shape::pyramid;
    default: return cell_shape::general;
  }
}
/// Puts the corners of a cell from VTK's order into the standard one, and the reverse: they differ in voxels, whose x
/// changes fastest, and in wedges, linear and quadratic, whose base 0 1 2 is counter-clockwise seen from outside.
inline void swap_vtk_order(unsigned type, vert_id* v) {
  if (type == 11) std::swap(v[2], v[3]), std::swap(v[6], v[7]);
  if (type == 13 || type == 26 || type == 31 || type == 32) std::swap(v[1], v[2]), std::swap(v[4], v[5]);
}

}  // namespace concino::detail
