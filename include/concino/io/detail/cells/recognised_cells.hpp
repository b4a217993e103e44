// Recognises tets, hexes, prisms and pyramids among the polyhedra of a flat_mesh.
#pragma once

#include <concino/io/detail/cells/canonical_cells.hpp>
#include <concino/io/flat_mesh.hpp>
#include <concino/io/write_context.hpp>
#include <concino/mesh/support/cell_recogniser.hpp>

namespace concino::detail {

/// The shape of poly p, whose faces begin at `first` in all.poly_faces.values. Unless it is general, known.cell has its
/// verts in the standard order.
inline cell_shape recognise(const flat_polyhedra& all, std::size_t p, std::size_t first, cell_recogniser& known) {
  known.clear();
  for (const face_id f : all.poly_faces[p]) {
    known.begin_face();
    for (const vert_id v : all.face_verts[f.raw()]) known.push(v);
    if (all.outward[first++] == 0) known.reverse_face();
  }
  return known.recognise();
}

/// Calls f(poly, shape, verts in the standard order) for each poly of a volume. The verts do not depend on how the mesh
/// stores its faces. If the shape is general, the verts are those of no cell.
template<class F>
void for_each_cell(flat_mesh& m, const F& f) {
  if (m.arity == 4 || m.arity == 8) {
    for (std::size_t p = 0; p < m.num_polys; ++p)
      f(p, m.arity == 4 ? cell_shape::tet : cell_shape::hex, m.poly_verts[p].data());
    return;
  }
  const flat_polyhedra& all = m.polyhedra();
  cell_recogniser known;
  std::size_t first = 0;
  for (std::size_t p = 0; p < m.num_polys; ++p) {
    const cell_shape s = recognise(all, p, first, known);
    if (s != cell_shape::general) make_canonical(s, known.cell);
    first += all.poly_faces[p].size();
    f(p, s, static_cast<const vert_id*>(known.cell));
  }
}

/// Errors: unsupported, because poly p is no standard cell.
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_general_cell(const write_context& c, flat_mesh& m,
                                                                      std::size_t p, std::string_view format) {
  c.throw_cannot_hold(format,
                      {"poly ", m.poly_index(p), ", a polyhedron of ", m.polyhedra().poly_faces[p].size(),
                       " faces that is not a tet, hex, prism or pyramid"},
                      ".hedra");
}

}  // namespace concino::detail
