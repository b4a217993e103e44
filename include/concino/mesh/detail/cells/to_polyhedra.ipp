// Conversion of cells to polyhedra; see to_polyhedra.hpp.
#pragma once

#include <concino/mesh/support/face_soup.hpp>
#include <concino/mesh/support/to_polyhedra.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace concino {

template<std::same_as<cell_arrays> Cells>
polyhedra_arrays to_polyhedra(Cells&& cells) {
  const cell_shape s = cells.arity == 4 ? cell_shape::tet : cell_shape::hex;
  const standard_cell& t = standard_cell_of(s);
  const std::size_t n = cells.num_polys();
  face_soup soup;
  soup.face_offsets.reserve(n * t.num_faces + 1);
  soup.face_verts.reserve(n * (s == cell_shape::tet ? 12 : 24));
  soup.poly_offsets.reserve(n + 1);
  for (std::size_t c = 0; c < n; ++c) soup.add_cell(s, cells.verts.data() + c * t.num_verts);
  std::vector<vert_id>().swap(cells.verts);
  return std::move(soup).unite(std::move(cells.points));
}

#ifdef CONCINO_COMPILED
template polyhedra_arrays to_polyhedra<cell_arrays>(cell_arrays&&);
#endif

}  // namespace concino
