// The writer of MEDIT files, text and binary: surfaces of triangles and quads; volumes of tets, hexes, prisms and
// pyramids, recognised by their faces.
#pragma once

#include <concino/io/detail/medit/medit_elements.hpp>
#include <concino/io/detail/medit/medit_format.hpp>
#include <concino/io/detail/medit/medit_output.hpp>
#include <concino/io/detail/text/write_common.hpp>

#include <string_view>
#include <vector>

namespace concino::detail {

class medit_writer {
  write_context& c_;
  flat_mesh& m_;
  medit_elements listed_;
  medit_output out_;
  std::uint64_t num_odd_ = 0;  // marks other than 0 and 1

 public:
  medit_writer(write_context& c, flat_mesh& m, bool binary) : c_(c), m_(m), listed_(c, m), out_(c.out, binary) {}

  void write() {
    declare();
    listed_.collect();
    declare_sections();
    out_.begin_file();
    while (out_.has_next()) write_section(out_.begin());
    out_.end_file();
    std::size_t kinds = 0;
    for (const std::size_t n : listed_.num_polys) kinds += n > 0;
    if (kinds > 1)
      c_.report.notes.push_back("the file lists polys of one shape after those of another: their order changed");
    if (listed_.num_large_faces)
      c_.report.lost.push_back(
          core::joined({"values of ", listed_.num_large_faces, " faces that are neither triangles nor quads"}));
    if (num_odd_)
      c_.report.lost.push_back(core::joined(
          {num_odd_,
           " marks of elements (\"corner\", \"required\", \"ridge\", \"entity\") that are neither 0 nor 1: written as 1"}));
  }

 private:
  void declare() {
    for (const char* const name : {"label", "corner", "required"}) c_.declare_stored<int>(element_kind::vert, name);
    for (const char* const name : {"label", "ridge", "required", "entity"})
      c_.declare_stored<int>(element_kind::edge, name);
    c_.declare_stored<int>(element_kind::poly, "label");
    c_.declare_stored<vec3>(element_kind::vert, "normal");
    if (m_.dimension == 2) c_.declare_stored<int>(element_kind::poly, "required");
    else
      for (const char* const name : {"label", "required", "entity"}) c_.declare_stored<int>(element_kind::face, name);
  }

  void declare_sections() {
    out_.add_section(nullptr, m_.points.size());
    for (std::size_t k = 0; k < std::size(medit_sections); ++k) {
      const medit_section& s = medit_sections[k];
      std::uint64_t n = 0;
      if (k < medit_elements::num_shapes) n = listed_.num_polys[k] + (k < 2 ? listed_.faces[k].size() : 0);
      else if (s.rows == medit_rows::edges) n = listed_.edges.size();
      else if (!s.mark) n = listed_.normals.size();
      else
        listed_.for_each_marked(s, [&](std::size_t, int x) {
          ++n;
          num_odd_ += x != 1;
        });
      out_.add_section(&s, n);
    }
  }

  void write_section(const medit_section* s) {
    if (!s) return write_vertices();
    const auto k = static_cast<std::size_t>(s - medit_sections);
    if (k < 2 && m_.dimension == 3) return write_faces(k);
    if (k < medit_elements::num_shapes) return write_polys(k);
    if (s->rows == medit_rows::edges) return write_edges();
    if (s->mark)
      return listed_.for_each_marked(*s, [&](std::size_t i, int) {
        out_.index(i);
        out_.end_row();
      });
    write_normals(s->rows == medit_rows::normals);
  }

  void write_point(const vec3& p) { out_.real(p.x), out_.real(p.y), out_.real(p.z); }

  void write_vertices() {
    const flat_values<int> label = m_.vert_values<int>("label");
    for (std::size_t v = 0; v < m_.points.size(); ++v) {
      write_point(m_.points[v]);
      out_.integer(label ? label[v] : 0);
      out_.end_row();
      c_.report_progress();
    }
  }

  void write_polys(std::size_t section) {
    const flat_values<int> label = m_.poly_values<int>("label");
    const vert_id* v = listed_.verts.data();
    for (std::size_t p = 0; p < listed_.sections.size(); ++p) {
      const std::size_t n = medit_sections[listed_.sections[p]].arity;
      if (listed_.sections[p] == section) {
        for (std::size_t i = 0; i < n; ++i) out_.index(v[i].raw());
        out_.integer(label ? label[p] : 0);
        out_.end_row();
      }
      v += n;
    }
  }

  void write_faces(std::size_t kind) {
    const flat_values<int> label = m_.face_values<int>("label");
    for (const std::uint32_t f : listed_.faces[kind]) {
      for (const vert_id v : m_.polyhedra().face_verts[f]) out_.index(v.raw());
      out_.integer(label ? label[f] : 0);
      out_.end_row();
    }
  }

  void write_edges() {
    const flat_values<int> label = m_.edge_values<int>("label");
    for (const std::uint32_t e : listed_.edges) {
      for (const vert_id v : m_.edge_verts()[e]) out_.index(v.raw());
      out_.integer(label ? label[e] : 0);
      out_.end_row();
    }
  }

  void write_normals(bool vectors) {
    const flat_values<vec3> normal = m_.vert_values<vec3>("normal");
    for (std::size_t i = 0; i < listed_.normals.size(); ++i) {
      const vec3& n = normal[listed_.normals[i]];
      if (vectors) write_point({c_.finite(n.x), c_.finite(n.y), c_.finite(n.z)});
      else out_.index(listed_.normals[i]), out_.index(i);
      out_.end_row();
    }
  }
};

/// Whether a path ends in .meshb, in upper or lower case.
inline bool is_meshb(std::string_view path) {
  constexpr std::string_view extension = ".meshb";
  if (path.size() < extension.size()) return false;
  for (std::size_t i = 0; i < extension.size(); ++i)
    if (const char c = path[path.size() - extension.size() + i]; c != extension[i] && (c | 0x20) != extension[i])
      return false;
  return true;
}

}  // namespace concino::detail

namespace concino {

inline void medit_format::write(write_context& c, flat_mesh& m) {
  detail::medit_writer(c, m, c.options.binary || detail::is_meshb(c.path)).write();
}

}  // namespace concino
