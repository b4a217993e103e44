// Writes MEDIT .mesh: surfaces of triangles and quads; volumes of tets, hexes, prisms and pyramids, told by their faces.
#pragma once

#include <concino/io/detail/medit_sections.hpp>
#include <concino/io/detail/properties.hpp>
#include <concino/io/detail/write_common.hpp>
#include <concino/mesh/cell_recogniser.hpp>

namespace concino::detail {

/// The polys in the order of the mesh: what each is, and its verts as numbers of the file in the order of the format.
struct medit_rows {
  std::vector<std::uint8_t> section;  // place in medit_sections
  std::vector<std::uint32_t> verts;
  std::size_t count[std::size(medit_sections)] = {};

  void end_row(std::size_t s) {
    section.push_back(static_cast<std::uint8_t>(s));
    ++count[s];
  }
};

template<class M>
void add_row(write_context<M>& c, const poly_t<M>& p, medit_rows& rows, [[maybe_unused]] cell_recogniser& known) {
  const M& m = c.mesh;
  std::size_t s = std::size(medit_sections);
  if constexpr (dimension_v<M> == 2) {  // the format has sections for triangles and quads, and for cells
    const std::size_t before = rows.verts.size();
    for (vert_t<M> v : adj_p2v(m, p)) rows.verts.push_back(c.number_of(v));
    const std::size_t n = rows.verts.size() - before;
    if (n == 3 || n == 4) s = n - 3;
    else c.cannot_hold(".mesh", {"poly ", index_of(m, p), ", a polygon of ", n, " verts"}, ".obj");
  } else if constexpr (arity_v<M> == 4 || arity_v<M> == 8) {  // tets and hexes need no recognising
    for (vert_t<M> v : adj_p2v(m, p)) rows.verts.push_back(c.number_of(v));
    s = arity_v<M> == 4 ? 2 : 3;
  } else {
    known.clear();
    std::size_t n = 0;
    for (face_t<M> f : adj_p2f(m, p)) {
      known.begin_face();
      for (vert_t<M> v : adj_f2v(m, f)) known.push(vert_id{c.number_of(v)});
      if (!face_is_outward(m, p, f)) known.reverse_face();
      ++n;
    }
    const cell_shape shape = known.recognise();
    if (shape == cell_shape::general)
      c.cannot_hold(".mesh", {"poly ", index_of(m, p), ", a polyhedron of ", n, " faces that is no tet, hex, prism or pyramid"}, ".hedra");
    for (unsigned i = 0; i < standard_cell_of(shape).num_verts; ++i) rows.verts.push_back(known.cell[i].raw());
    s = 2 + static_cast<std::size_t>(shape);
  }
  rows.end_row(s);
}

template<class M>
void write_medit(write_context<M>& c) {
  const M& m = c.mesh;
  const int* const vert_label = values_if_any<int>(m, element_kind::vert, "label");
  const int* const poly_label = values_if_any<int>(m, element_kind::poly, "label");
  c.keep(element_kind::vert, "label", typeid(int));
  c.keep(element_kind::poly, "label", typeid(int));
  c.out << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << num_verts(m) << '\n';
  for (const vert_t<M> v : verts(m)) {
    write_point(c.out, c.next_point(v));
    c.out << ' ' << (vert_label ? vert_label[index_of(m, v)] : 0) << '\n';
    c.tell();
  }

  medit_rows rows;
  cell_recogniser known;
  std::vector<int> labels;
  for (poly_t<M> p : polys(m)) {
    add_row(c, p, rows, known);
    const int label = poly_label ? poly_label[index_of(m, p)] : 0;
    labels.push_back(label);
    c.tell();
  }
  std::size_t kinds = 0;
  for (std::size_t s = 0; s < std::size(medit_sections); ++s) {
    if (rows.count[s] == 0) continue;
    ++kinds;
    const medit_section& section = medit_sections[s];
    c.out << section.keyword << '\n' << rows.count[s] << '\n';
    std::size_t at = 0;
    for (std::size_t p = 0; p < rows.section.size(); ++p) {
      const std::size_t n = medit_sections[rows.section[p]].arity;
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

}  // namespace concino::detail
