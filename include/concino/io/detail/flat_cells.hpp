// Recognises tets, hexes, prisms and pyramids among the polyhedra of a flat_mesh.
#pragma once

#include <concino/io/flat_mesh.hpp>
#include <concino/mesh/cell_recogniser.hpp>

namespace concino::detail {

/// The shape of poly p, whose faces begin at `first` in all.poly_faces.values. Unless it is general, known.cell has its verts in the standard order.
inline cell_shape recognise(const flat_polyhedra& all, std::size_t p, std::size_t first, cell_recogniser& known) {
  known.clear();
  for (const face_id f : all.poly_faces[p]) {
    known.begin_face();
    for (const vert_id v : all.face_verts[f.raw()]) known.push(v);
    if (all.outward[first++] == 0) known.reverse_face();
  }
  return known.recognise();
}

}  // namespace concino::detail
