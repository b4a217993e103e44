// The writer of TetGen's .node, .ele, .face and .edge files.
#pragma once

#include <concino/io/detail/cells/recognised_cells.hpp>
#include <concino/io/detail/files/system_files.hpp>
#include <concino/io/detail/tetgen/ele_format.hpp>
#include <concino/io/detail/tetgen/tetgen_files.hpp>
#include <concino/io/detail/tetgen/tetgen_output.hpp>
#include <concino/io/detail/tetgen/tetgen_paths.hpp>

#include <memory>
#include <string>

namespace concino::detail {

inline void write_tets(text_sink& out, write_context& c, flat_mesh& m) {
  const tetgen_values values(c, m, element_kind::poly);
  out << m.num_polys << " 4 " << values.attributes.size() + (values.label ? 1u : 0u) << '\n';
  for_each_cell(m, [&](std::size_t p, cell_shape s, const vert_id* v) {
    if (s != cell_shape::tet)
      c.throw_cannot_hold(".ele", {"poly ", m.poly_index(p), ", which is not a tet"},
                          s == cell_shape::general ? ".hedra" : ".mesh, .vtu or .hedra");
    out << p;
    for (std::size_t k = 0; k < 4; ++k) out << ' ' << v[k].raw();
    if (values.label) out << ' ' << values.label[p];
    for (const flat_values<double>& a : values.attributes) {
      out << ' ';
      write_real(out, c.finite(a[p]));
    }
    out << '\n';
    c.report_progress();
  });
}

/// Writes the faces or edges that have a label other than 0 to a file of their own, if there is one. An old file that
/// would give its labels to the new mesh becomes an empty list. `verts_of(i)` are the verts of element i of n.
template<class Verts>
void write_labelled(tetgen_files& files, const std::string& path, bool sync, const flat_values<int>& label,
                    std::size_t n, const Verts& verts_of) {
  std::size_t labelled = 0;
  for (std::size_t i = 0; label && i < n; ++i) labelled += label[i] != 0;
  if (labelled == 0 && status_of(path).kind != file_kind::regular) return;
  files.write(path, sync, [&](text_sink& out) {
    out << labelled << " 1\n";
    for (std::size_t i = 0, number = 0; number < labelled; ++i) {
      if (label[i] == 0) continue;
      out << number++;
      for (const vert_id v : verts_of(i)) out << ' ' << v.raw();
      out << ' ' << label[i] << '\n';
    }
  });
}

}  // namespace concino::detail

namespace concino {

inline void ele_format::write(write_context& c, flat_mesh& m) {
  using detail::tetgen_path;
  if (c.path.empty())
    core::throw_joined<unsupported>({c.name, ": .ele lists the tets of points that another file lists, .node, so that ",
                                     "no text holds both; save the mesh to a path, or as .mesh"});
  auto files = std::make_unique<detail::tetgen_files>();
  const bool is_node = detail::ends_in(c.path, ".node"), sync = c.options.sync;
  const auto write_points = [&](text_sink& out) { detail::write_tetgen_points(out, c, m); };
  const auto write_tets = [&](text_sink& out) { detail::write_tets(out, c, m); };
  if (is_node) {
    write_points(c.out);
    files->write(tetgen_path(c.path, ".ele"), sync, write_tets);
  } else {
    files->write(tetgen_path(c.path, ".node"), sync, write_points);
    write_tets(c.out);
  }
  c.declare_stored<int>(element_kind::face, "label");
  const flat_values<int> of_faces = m.face_values<int>("label");
  detail::write_labelled(*files, tetgen_path(c.path, ".face"), sync, of_faces,
                         of_faces ? m.polyhedra().face_verts.size() : 0,
                         [&](std::size_t f) { return m.polyhedra().face_verts[f]; });
  c.declare_stored<int>(element_kind::edge, "label");
  const flat_values<int> of_edges = m.edge_values<int>("label");
  detail::write_labelled(*files, tetgen_path(c.path, ".edge"), sync, of_edges, of_edges ? m.edge_verts().size() : 0,
                         [&](std::size_t e) { return m.edge_verts()[e]; });
  c.companions = std::move(files);
}

}  // namespace concino
