// The values of a VTK file as properties of the mesh: those of cells become values of polys and of faces.
#pragma once

#include <concino/io/detail/vtk/vtk_grid.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace concino::detail {

/// Whether one of the cells has a value other than the default one.
inline bool has_value_in(const property_column& c, const std::vector<std::uint32_t>& cells) {
  const value_type& type = c.values->operations();
  const column defaults(type, 1);
  const auto* const values = static_cast<const unsigned char*>(c.values->data());
  for (const std::uint32_t i : cells)
    if (std::memcmp(values + i * type.size, defaults.data(), type.size) != 0) return true;
  return false;
}

/// Whether the cells are all in their order.
inline bool keeps_order(const std::vector<std::uint32_t>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells[i] != i) return false;
  return true;
}

/// Moves the values of verts, and copies those of cells to the polys and faces that the cells became. Values of faces
/// only, or of polys only, have default values at the others in the file: they become no property of these.
template<class Contents>
void set_properties_from_grid(vtk_grid& grid, const std::vector<std::uint32_t>& poly_cells,
                              const std::vector<std::uint32_t>& face_cells, Contents& out) {
  constexpr element_kind kinds[] = {element_kind::vert, element_kind::poly, element_kind::face, element_kind::mesh};
  for (const element_kind kind : kinds)
    for (property_column& c : grid.columns) {
      const bool of_cells = kind == element_kind::poly || kind == element_kind::face;
      if (c.kind != (of_cells ? element_kind::poly : kind)) continue;
      if (kind == element_kind::poly && !face_cells.empty() && !has_value_in(c, poly_cells) &&
          has_value_in(c, face_cells))
        continue;
      if (kind == element_kind::face && (face_cells.empty() || !has_value_in(c, face_cells))) continue;
      if (!of_cells ||
          (kind == element_kind::poly && (poly_cells.size() == grid.size() && keeps_order(poly_cells)))) {
        out.properties.push_back(std::move(c));
        continue;
      }
      const std::vector<std::uint32_t>& cells = kind == element_kind::poly ? poly_cells : face_cells;
      const value_type& type = c.values->operations();
      auto* const to = static_cast<unsigned char*>(out.add_property(kind, c.name, type, cells.size()));
      const auto* const from = static_cast<const unsigned char*>(c.values->data());
      for (std::size_t i = 0; i < cells.size(); ++i)
        std::memcpy(to + i * type.size, from + cells[i] * type.size, type.size);
    }
}

}  // namespace concino::detail
