// The writer of MEDIT .mesh: surfaces of triangles and quads; volumes of tets, hexes, prisms and pyramids, recognised by their faces.
#pragma once

#include <concino/io/detail/medit_sections.hpp>
#include <concino/io/detail/medit_format.hpp>
#include <concino/io/detail/write_common.hpp>
#include <concino/mesh/cell_recogniser.hpp>

namespace concino::detail {

/// The polys in the order of the mesh: the shape of each, and its verts as numbers of the file, in the order of the format.
struct medit_rows {
  std::vector<std::uint8_t> section;  // index in medit_sections
  std::vector<std::uint32_t> verts;
  std::size_t count[std::size(medit_sections)] = {};

  void end_row(std::size_t s) {
    section.push_back(static_cast<std::uint8_t>(s));
    ++count[s];
  }
};

inline void add_row(const write_context& c, flat_mesh& m, std::size_t p, medit_rows& rows, cell_recogniser& known, const std::uint8_t*& outward) {
  std::size_t s = std::size(medit_sections);
  if (m.dimension == 2) {
    for (const vert_id v : m.poly_verts[p]) rows.verts.push_back(v.raw());
    const std::size_t n = m.poly_verts[p].size();
    if (n == 3 || n == 4) s = n - 3;
    else c.throw_cannot_hold(".mesh", {"poly ", m.poly_index(p), ", a polygon of ", n, " verts"}, ".obj");
  } else if (m.arity == 4 || m.arity == 8) {
    for (const vert_id v : m.poly_verts[p]) rows.verts.push_back(v.raw());
    s = m.arity == 4 ? 2 : 3;
  } else {
    known.clear();
    const flat_polyhedra& all = m.polyhedra();
    for (const face_id f : all.poly_faces[p]) {
      known.begin_face();
      for (const vert_id v : all.face_verts[f.raw()]) known.push(v);
      if (*outward++ == 0) known.reverse_face();
    }
    const cell_shape shape = known.recognise();
    if (shape == cell_shape::general)
      c.throw_cannot_hold(".mesh", {"poly ", m.poly_index(p), ", a polyhedron of ", all.poly_faces[p].size(), " faces that is not a tet, hex, prism or pyramid"}, ".hedra");
    for (unsigned i = 0; i < standard_cell_of(shape).num_verts; ++i) rows.verts.push_back(known.cell[i].raw());
    s = 2 + static_cast<std::size_t>(shape);
  }
  rows.end_row(s);
}

}  // namespace concino::detail

namespace concino {

inline void medit_format::write(write_context& c, flat_mesh& m) {
  const flat_values<int> vert_label = m.vert_values<int>("label"), poly_label = m.poly_values<int>("label");
  c.declare_stored<int>(element_kind::vert, "label");
  c.declare_stored<int>(element_kind::poly, "label");
  c.out << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << m.points.size() << '\n';
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    detail::write_point(c.out, m.points[v]);
    c.out << ' ' << (vert_label ? vert_label[v] : 0) << '\n';
    c.report_progress();
  }

  detail::medit_rows rows;
  cell_recogniser known;
  const bool by_faces = m.dimension == 3 && m.arity != 4 && m.arity != 8;
  const std::uint8_t* outward = by_faces ? m.polyhedra().outward.data() : nullptr;
  std::vector<int> labels;
  for (std::size_t p = 0; p < m.num_polys; ++p) {
    detail::add_row(c, m, p, rows, known, outward);
    labels.push_back(poly_label ? poly_label[p] : 0);
    c.report_progress();
  }
  std::size_t kinds = 0;
  for (std::size_t s = 0; s < std::size(detail::medit_sections); ++s) {
    if (rows.count[s] == 0) continue;
    ++kinds;
    const detail::medit_section& section = detail::medit_sections[s];
    c.out << section.keyword << '\n' << rows.count[s] << '\n';
    std::size_t at = 0;
    for (std::size_t p = 0; p < rows.section.size(); ++p) {
      const std::size_t n = detail::medit_sections[rows.section[p]].arity;
      if (rows.section[p] == s) {
        for (std::size_t i = 0; i < n; ++i) c.out << rows.verts[at + i] + 1 << ' ';
        c.out << labels[p] << '\n';
      }
      at += n;
    }
  }
  c.out << "End\n";
  if (kinds > 1) c.report.notes.push_back("the file lists polys of one shape after those of another: their order changed");
}

}  // namespace concino
