// The writers of TetGen's surfaces, .smesh and .poly.
#pragma once

#include <concino/io/detail/tetgen/smesh_format.hpp>
#include <concino/io/detail/tetgen/tetgen_output.hpp>

namespace concino::detail {

/// Writes points, facets, and that there are no holes and no regions. has_polygons: as .poly.
inline void write_smesh(write_context& c, flat_mesh& m, bool has_polygons) {
  write_tetgen_points(c.out, c, m);
  const flat_values<int> label = m.num_polys > 0 ? m.poly_values<int>("label") : flat_values<int>();
  if (label) c.declare_stored<int>(element_kind::poly, "label");
  c.out << m.num_polys << (label ? " 1\n" : " 0\n");
  for (std::size_t p = 0; p < m.num_polys; ++p) {
    if (has_polygons) {
      c.out << "1 0";
      if (label) c.out << ' ' << label[p];
      c.out << '\n';
    }
    const auto verts = m.poly_verts[p];
    c.out << verts.size();
    for (const vert_id v : verts) c.out << ' ' << v.raw();
    if (label && !has_polygons) c.out << ' ' << label[p];
    c.out << '\n';
    c.report_progress();
  }
  c.out << "0\n0\n";
}

}  // namespace concino::detail

namespace concino {

inline void smesh_format::write(write_context& c, flat_mesh& m) { detail::write_smesh(c, m, false); }
inline void poly_format::write(write_context& c, flat_mesh& m) { detail::write_smesh(c, m, true); }

}  // namespace concino
